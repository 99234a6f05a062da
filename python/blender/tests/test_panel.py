import bpy
from support import InBlender

from lancret_blender import deferred, panel


class Layout:
    """A mock of Blender's layout: collects texts and the names of drawn properties."""

    def __init__(self, texts):
        self.texts = texts

    def part(self, *_, **__):
        return Layout(self.texts)

    box = row = column = part

    def label(self, text="", icon="NONE"):
        self.texts.append(text)

    def prop(self, owner, name, **_):
        self.texts.append(owner.bl_rna.properties[name].name)

    def operator(self, name, **_):
        self.texts.append(name)


class Panel(InBlender):
    def texts(self):
        class Drawn:
            layout = Layout([])
            _error = panel.OBJECT_PT_lancret._error
            _figures = panel.OBJECT_PT_lancret._figures

        class Context:
            object = bpy.context.object
            region = type("Region", (), {"width": 4000})

        self.assertTrue(panel.OBJECT_PT_lancret.poll(Context))
        panel.OBJECT_PT_lancret.draw(Drawn(), Context)
        return Drawn.layout.texts

    def test_shows_values_and_figures(self):
        obj = self.add()
        texts = self.texts()
        for name in ("Strands", "Viewport share", "Scalp", "Blend", "Seed", "File"):
            self.assertIn(name, texts)
        self.assertIn(f"{obj.lancret.strands} of 400 strands shown", texts)

    def test_shows_errors(self):
        obj = self.add(self.folder / "none.toml")
        self.assertTrue(obj.lancret.error)
        self.assertIn(obj.lancret.error, self.texts())

    def test_is_hidden_for_other_objects(self):
        bpy.ops.mesh.primitive_plane_add()
        self.assertFalse(panel.OBJECT_PT_lancret.poll(bpy.context))


class Live(InBlender):
    def test_update_of_the_timer_regrows(self):
        obj = self.add()
        obj.lancret.count = 150
        self.assertEqual(obj.lancret.all_strands, 400)
        deferred._names.update((obj.name, "a deleted object"))
        self.assertIsNone(deferred._tick())
        self.assertEqual(obj.lancret.all_strands, 150)
        self.assertFalse(deferred._names)
