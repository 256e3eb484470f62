// 0.0 and -0.0 are equal, and no text tells them apart.
c = range(1, 3);
zero = cond(c < 2, 0 * 0.25, 0 / -4.0);
text = format("{} {:.2}", zero, zero);
if c == 3 { zero = -0.0; }
return [c, zero, text, str(0 * -1.5), -sin(-0.0)];
