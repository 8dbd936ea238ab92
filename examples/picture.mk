# A picture in parts by make, on as many cores as -j says:
#   make -j4 -f picture.mk SCENE=scene.lancer OUT=big.png [PARTS=12] [OPTIONS='--samples 3']
# After a crash or a change the same command draws what is missing or of another scene.
LANCER ?= lancer
PARTS ?= 12
names := $(foreach k,$(shell seq $(PARTS)),$(OUT).parts/$(k)-of-$(PARTS).exr)

$(OUT): $(names)
	$(LANCER) join $^ -o $@

# Always asked for: Lancer itself knows what is whole and of this scene.
$(names): always
	@mkdir -p $(OUT).parts
	$(LANCER) render $(SCENE) $(OPTIONS) --threads 1 --quiet --resume \
	    --part $(subst -of-,/,$(basename $(notdir $@))) -o $@

.PHONY: always
