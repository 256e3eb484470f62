// No least element.
return min([x for x in [1, 2, 3] if x > 3]);  // conflict: there must be something to choose from
