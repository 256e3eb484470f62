// forbid: lid=true
// forbid: lid=false
lid = flip();  // conflict: lid is not true, by --forbid 'lid=true'; lid is not false, by --forbid 'lid=false'
return lid;
