"""Loads a program: the script and what it imports."""

from collections import Counter
from pathlib import Path

from .builtins import BUILTINS
from .labels import label
from .names import resolve
from .parser import parse, parse_expression
from .syntax import Import, ListDisplay, Literal, Module, Param, ProgramError, Unary


class Loader:
    """Loads each file once. `sources` maps paths to texts and stands before the disk; `libraries` are the folders in which
    imports are looked for after the importing file's own."""

    def __init__(self, libraries, sources):
        self.libraries = libraries
        self.sources = sources
        self.modules = {}
        self.loading = []
        self.names = Counter()

    def text(self, path):
        if path in self.sources:
            return self.sources[path]
        return path.read_text(encoding="utf-8")

    def exists(self, path):
        return path in self.sources or path.is_file()

    def find(self, statement):
        importer = Path(statement.place.file)
        for folder in [importer.parent, *self.libraries]:
            path = folder / statement.path
            if self.exists(path):
                return path if path in self.sources else path.resolve()
        raise ProgramError(statement.place, f"there is no file {statement.path!r} to import")

    def load(self, path):
        """The module of a file."""
        if path in self.modules:
            return self.modules[path]
        self.loading.append(path)
        library = any(path.is_relative_to(folder.resolve()) for folder in self.libraries)
        module = Module(str(path), self.step(path), parse(self.text(path), str(path)), library)
        for statement in module.body:
            if isinstance(statement, Import):
                self.load_import(module, statement)
        resolve(module, BUILTINS)
        label(module, BUILTINS)
        self.loading.pop()
        self.modules[path] = module
        return module

    def step(self, path):
        """The step of addresses that an imported file is: its name, and a number if another one has that name. The
        script is none."""
        if len(self.loading) == 1:
            return ""
        self.names[path.name] += 1
        count = self.names[path.name]
        return path.name if count == 1 else f"{path.name}#{count}"

    def load_import(self, module, statement):
        path = self.find(statement)
        if path in self.loading:
            raise ProgramError(statement.place, "these files import each other")
        imported = self.load(path)
        statement.file = imported.file
        if imported in module.imports:
            module.imports.remove(imported)
        module.imports.append(imported)


class LoadedProgram:
    """The script's module, and all modules by their file."""

    def __init__(self, main, modules):
        self.main = main
        self.modules = modules


def load_program(path, libraries=(), sources=None):
    """Loads a script with its imports. Raises ProgramError, or OSError if the script cannot be read."""
    path = Path(path) if sources else Path(path).resolve()
    loader = Loader([Path(each) for each in libraries], sources or {})
    main = loader.load(path)
    return LoadedProgram(main, {module.file: module for module in loader.modules.values()})


def constant(node):
    """The value of a literal, a negative number or a list of such."""
    match node:
        case Literal(value=value):
            return value
        case Unary(operator="-", operand=operand):
            return -constant(operand)
        case ListDisplay(items=items):
            return tuple(constant(item) for item in items)
    raise ProgramError(node.place, "this is no constant")


def param_values(program, settings):
    """The values of `--set NAME=VALUE`, from pairs of texts. The text is the string where the default is a string."""
    defaults = {}
    for module in program.modules.values():
        defaults.update({each.name: each.default for each in module.body if isinstance(each, Param)})
    values = {}
    for name, setting in settings:
        default = defaults[name]
        is_text = isinstance(default, Literal) and isinstance(default.value, str)
        if is_text and not setting.startswith('"'):
            values[name] = setting
        else:
            values[name] = constant(parse_expression(setting, "--set"))
    return values
