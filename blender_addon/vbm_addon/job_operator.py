# SPDX-License-Identifier: GPL-3.0-or-later
"""What all of the add-on's operators have in common.

Scripts and the redo panel call execute(), which computes in place. Invoked from the interface, the
same work runs in a thread while a modal handler shows progress and waits for Esc. Both end in
finish(), the only step that changes the file; whatever fails before it leaves the file untouched, and
finish() itself takes back what it made if it fails.
"""

import time
import traceback

import bpy

from . import compat, library, options, session, source
from .job import Job, was_cancelled
from .model import Request

# Events that go on to Blender while a job runs, so that the view can be turned.
_VIEW_EVENTS = {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "MOUSEMOVE", "INBETWEEN_MOUSEMOVE",
                "TRACKPADPAN", "TRACKPADZOOM", "NDOF_MOTION", "WINDOW_DEACTIVATE"}


class JobOperator:
    """Mixin for bpy.types.Operator. Subclasses give `doing`, work() and finish()."""

    bl_options = {"REGISTER", "UNDO"}
    #: Said while it runs: "Building balls".
    doing = ""
    #: Object types it works on.
    source_types = source.TYPES
    #: Modes it works in. It must stay possible after the operator ran, or the redo panel goes away.
    modes = {"OBJECT"}
    _job = None
    _timer = None

    # -- What subclasses do --

    def work(self, request, progress):
        """Compute; runs in a thread, must not touch bpy."""
        raise NotImplementedError

    def is_quick(self, request):
        """Whether work() has nothing to compute that is not in the cache."""
        return request.cached is not None

    def finish(self, context, obj, request, result):
        """Write the results; returns a session.Outcome."""
        raise NotImplementedError

    # -- Blender's side --

    @classmethod
    def poll(cls, context):
        if library.vbm is None:
            cls.poll_message_set(library.problem)
            return False
        if context.mode not in cls.modes:
            cls.poll_message_set("Works in Object Mode: press Tab")
            return False
        obj, problem = source.resolve(context)
        if obj is not None and obj.type not in cls.source_types:
            problem = f"{obj.name} is not a mesh: convert it first"
        if problem:
            cls.poll_message_set(problem)
        return not problem

    def _prepare(self, context):
        obj, problem = source.resolve(context)
        if obj is None:
            raise source.SourceError(problem)
        data = source.read(context, obj, self.use_modifiers, self.ignore_faces,
                           self.normals_attribute)
        return obj, Request(data, options.build_arguments(self))

    def execute(self, context):
        began = time.perf_counter()
        wm = context.window_manager
        request = None
        wm.progress_begin(0, 100)
        try:
            obj, request = self._prepare(context)
            known = self.is_quick(request)
            result = self.work(request, lambda fraction, stage: wm.progress_update(100 * fraction))
            self._conclude(context, obj, request, result, time.perf_counter() - began, known)
        except Exception as error:  # reported in words; nothing was changed
            return self._fail(context, error, request)
        finally:
            wm.progress_end()
        if self.options.is_repeat or self.options.is_repeat_last:
            options.keep_shared(self, context)
        return {"FINISHED"}

    def invoke(self, context, event):
        options.take_shared(self, context)
        if session.job is not None:
            self.report({"ERROR"}, "Another ball model is being computed: wait, or press Esc")
            return {"CANCELLED"}
        try:
            obj, request = self._prepare(context)
        except Exception as error:
            return self._fail(context, error, None)
        if bpy.app.background or context.window is None or self.is_quick(request):
            return self.execute(context)
        self._name, self._request, self._began = obj.name, request, time.perf_counter()
        self._job = session.job = Job(lambda progress: self.work(request, progress))
        wm = context.window_manager
        self._timer = wm.event_timer_add(0.1, window=context.window)
        self._workspace = context.workspace
        wm.progress_begin(0, 100)
        wm.modal_handler_add(self)
        self._show(context)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self.cancel(context)
            self.report({"INFO"}, f"{self.doing} was cancelled; nothing was changed")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH" if event.type in _VIEW_EVENTS else "RUNNING_MODAL"}
        if self._job.running:
            self._show(context)
            return {"PASS_THROUGH"}
        job = self._job
        self._end(context)
        try:
            if job.error is not None:
                raise job.error
            obj = context.view_layer.objects.get(self._name)
            if obj is None:
                raise source.SourceError(f"{self._name} went away while its balls were computed")
            self._conclude(context, obj, self._request, job.result,
                           time.perf_counter() - self._began)
        except Exception as error:
            return self._fail(context, error, self._request)
        return {"FINISHED"}

    def cancel(self, context):
        """Esc, and Blender's own wish: another file is opened, or the window closed."""
        if self._job is not None:
            self._job.cancel()
            self._end(context)
            session.set_outcome(session.Outcome(f"{self.doing} was cancelled"))

    # -- Telling --

    def _show(self, context):
        job, wm = self._job, context.window_manager
        percent = 100.0 * min(max(job.fraction, 0.0), 1.0)
        wm.vbm.progress = percent
        wm.progress_update(percent)
        stage = f": {job.stage}" if job.stage else ""
        self._workspace.status_text_set(f"{self.doing}{stage}   {percent:.0f} %   Esc: cancel")
        _redraw(context)

    def _end(self, context):
        wm = context.window_manager
        wm.event_timer_remove(self._timer)
        wm.progress_end()
        self._workspace.status_text_set(None)
        self._job = session.job = None
        _redraw(context)

    def _conclude(self, context, obj, request, result, seconds, known=False):
        outcome = self.finish(context, obj, request, result)
        outcome.object_name = obj.name
        outcome.notes = [_sentence(note) for note in outcome.notes]
        outcome.lines.append(f"{seconds:.1f} s" if seconds >= 0.05 else
                             "At once, from the last balls" if known else f"{seconds:.2f} s")
        session.set_outcome(outcome)
        self.report({"WARNING" if outcome.notes else "INFO"},
                    ". ".join([outcome.title] + outcome.notes))
        _redraw(context)

    def _fail(self, context, error, request):
        if was_cancelled(error):
            self.report({"INFO"}, f"{self.doing} was cancelled; nothing was changed")
            return {"CANCELLED"}
        outcome = session.Outcome(f"{self.doing} failed", failed=True)
        known = isinstance(error, (source.SourceError, library.vbm.Error, MemoryError))
        text = str(error) or type(error).__name__
        if not known:
            traceback.print_exception(type(error), error, error.__traceback__)
            text = f"a defect in the add-on, please report it: {text}"
        if request is not None:
            if not isinstance(error, source.SourceError):
                text = f"{request.source.name}: {text}"
            if request.source.own and getattr(error, "kind", "") in ("vertex", "face"):
                outcome.kind = error.kind
                outcome.elements = tuple(error.elements)
                outcome.total = error.total
            outcome.object_name = request.source.name
        outcome.lines.append(text)
        session.set_outcome(outcome)
        _redraw(context)
        self.report({"ERROR"}, text)
        return {"CANCELLED"}


def _sentence(text):
    """As Blender writes its messages: a capital at the beginning, no full stop at the end."""
    text = text.strip().rstrip(".")
    return text[:1].upper() + text[1:]


def _redraw(context):
    """Redraw the sidebars. The view beside them may be a heavy scene, and has not changed."""
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                for region in area.regions:
                    if region.type == "UI":
                        region.tag_redraw()


def draw_running(layout, context):
    """The sidebar's progress bar, while a job runs."""
    column = layout.column(align=True)
    compat.draw_progress(column, context.window_manager.vbm, "progress",
                         _sentence(session.job.stage or "working"))
    column.label(text="Cancel", icon="EVENT_ESC")
