// Topics of documents of which nobody says how many there are: a hierarchical Dirichlet process (Teh, Jordan,
// Beal and Blei 2006), told by who sits at whose table. A table of a document serves a dish, a topic, which
// tables of other documents may serve as well.
import "std/process.sol";

documents = [[0, 0, 1], [2, 3]];

all_words = sum([length(d) for d in documents]);
dish = crp(all_words, 1.0);
topics = [dirichlet([1, 1, 1, 1]) for i in 1..all_words];
served = [];
before = 0;
for words in documents {
  seat = crp(length(words), 1.0);
  for i in 0..length(words) - 1 {
    topic = dish[before + seat[i]];
    observe(Categorical(topics[topic]), words[i]);
    served = served + [topic];
  }
  before += length(words);
}
return served[0] == served[1], served[0] == served[2], served[0] == served[3], served[3] == served[4];
