# Draws a picture in parts by make, on as many cores as -j says:
#   make -j4 -f picture.mk SCENE=scene.lancer OUT=big.png [PARTS=12] [OPTIONS='--samples 3']
# After a crash or a change, the same command draws only parts that are missing or belong to another
# scene.
LANCER ?= lancer
PARTS ?= 12
names := $(foreach k,$(shell seq $(PARTS)),$(OUT).parts/$(k)-of-$(PARTS).exr)

$(OUT): $(names)
	$(LANCER) join $^ -o $@

# Always run: Lancer itself knows which parts are complete and belong to this scene.
$(names): always
	@mkdir -p $(OUT).parts
	$(LANCER) render $(SCENE) $(OPTIONS) --threads 1 --quiet --resume \
	    --part $(subst -of-,/,$(basename $(notdir $@))) -o $@

.PHONY: always
