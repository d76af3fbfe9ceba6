"""Octrees from silhouettes: figures 12, 13, 15 and 16 of Ahuja and Veenstra, Generating Octrees from
Object Silhouettes in Orthographic Views, PAMI 11(2), 1989, and their averages beside ours."""

# The objects of figure 16, each as its octree after 3, 9 and 13 views.
DRAWN = {
    "a-cylinder": ("cylinder", 96),
    "b-cone": ("cone", 96),
    "c-sphere": ("sphere", 48),
    "d-pyramid": ("pyramid",),
    "e-wedge": ("wedge",),
    "f-octagonal-prism": ("octagonal-prism",),
    "g-rectangular-prism": ("rectangular-prism",),
    "h-arc": ("arc", 32),
    "j-self-occluding": ("self-occluding", 64),
    "k-diamond": ("diamond",),
}
STAGES = (3, 9, 13)
FROM = "0.55,-0.71,0.44"

# Cells of these drawings: 64 x 64 pixels, as in the paper's measurements of time.
MASK_SIZE = 64


def experiment(workshop):
    """Figures 12, 13, 15: accuracy with 3, 9 and 13 views, with and without growing (txt, csv, svg)

    Twelve objects in 100 random orientations each, and what other readings of the paper give."""
    print(workshop.run("spoctree-silhouettes", "experiment", "-o", workshop.output, "--variants"),
          end="")


def drawings_of(letter_and_name):
    def draw(workshop):
        masks = workshop.scratch / f"masks-{letter_and_name}"
        spo = workshop.scratch / f"silhouettes-{letter_and_name}.spo"
        workshop.run("spoctree-silhouettes", "render", workshop.model(*DRAWN[letter_and_name]),
                     "-o", masks, "--size", MASK_SIZE, "--square-pixels")
        workshop.run("spoctree-silhouettes", "build", masks, "-o", spo, "--stages")
        for views in STAGES:
            stage = spo if views == STAGES[-1] else spo.with_stem(f"{spo.stem}-{views}")
            for ending in ("svg", "png"):
                workshop.run(
                    "spoctree-client", "draw", stage, "--from", FROM, "-o",
                    workshop.output / f"silhouettes-16-{letter_and_name}-{views}.{ending}")

    letter, name = letter_and_name.split("-", 1)
    draw.__doc__ = f"Figure 16({letter}): {name} from 3, 9 and 13 silhouettes, drawn (svg, png)"
    return draw


FIGURES = {"silhouettes-experiment": experiment} | {
    f"silhouettes-16-{name}": drawings_of(name) for name in DRAWN}
