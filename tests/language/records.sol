side = 3;
record Obj(kind, width, height = side, turned = false);
a = Obj("table", 3);
b = Obj(height: 1, width: 2, kind: "sofa");
print(a, b);     // prints: Obj(kind: "table", width: 3, height: 3, turned: false) Obj(kind: "sofa", width: 2, height: 1, turned: false)
a.turned = true;
a.width += 1;
print(a.width, a.turned, [a.kind][0], Obj);        // prints: 4 true table record Obj
objs = [a, b];
objs[1].kind = "chair";
print([o.kind for o in objs], b.kind);             // prints: ["table", "chair"] sofa
record Node(value, rest);
list = Node(1, Node(2, nil));
list.rest.value = 5;
print(list);                                       // prints: Node(value: 1, rest: Node(value: 5, rest: nil))
record Empty();
print(Empty() == Empty(), Empty());                // prints: true Empty()
