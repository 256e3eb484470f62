// 21 documents of 20 words of a vocabulary of four. Each document is a mixture of two topics, each topic a
// distribution over words (Blei, Ng and Jordan 2003).
documents = [
    [0, 1, 0, 1, 0, 1, 0, 3, 0, 3, 0, 1, 0, 1, 0, 1, 0, 3, 0, 3],
    [1, 0, 1, 0, 1, 0, 1, 2, 3, 0, 1, 0, 1, 0, 1, 0, 1, 2, 3, 0],
    [0, 1, 0, 1, 0, 3, 0, 1, 0, 3, 0, 1, 0, 1, 0, 3, 0, 1, 0, 3],
    [3, 0, 1, 2, 1, 0, 1, 0, 1, 0, 3, 0, 1, 2, 1, 0, 1, 0, 1, 0],
    [0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1],
    [1, 0, 3, 0, 1, 0, 1, 0, 1, 2, 1, 0, 3, 0, 1, 0, 1, 0, 1, 2],
    [0, 1, 0, 3, 0, 1, 0, 3, 0, 1, 0, 1, 0, 3, 0, 1, 0, 3, 0, 1],
    [1, 2, 3, 0, 3, 0, 1, 0, 3, 0, 1, 2, 3, 0, 3, 0, 1, 0, 3, 0],
    [0, 1, 2, 1, 0, 3, 2, 1, 0, 3, 0, 1, 2, 1, 0, 3, 2, 1, 0, 3],
    [3, 2, 1, 2, 3, 0, 3, 2, 1, 0, 3, 2, 1, 2, 3, 0, 3, 2, 1, 0],
    [0, 3, 0, 1, 2, 3, 0, 3, 2, 3, 0, 3, 0, 1, 2, 3, 0, 3, 2, 3],
    [1, 0, 3, 0, 1, 2, 3, 2, 3, 2, 1, 0, 3, 0, 1, 2, 3, 2, 3, 2],
    [2, 1, 0, 3, 0, 3, 2, 3, 0, 3, 2, 1, 0, 3, 0, 3, 2, 3, 0, 3],
    [3, 2, 1, 2, 3, 0, 1, 2, 3, 0, 3, 2, 1, 2, 3, 0, 1, 2, 3, 0],
    [2, 1, 2, 3, 0, 3, 2, 3, 2, 3, 2, 1, 2, 3, 0, 3, 2, 3, 2, 3],
    [3, 2, 3, 2, 3, 0, 3, 2, 3, 0, 3, 2, 3, 2, 3, 0, 3, 2, 3, 0],
    [2, 3, 2, 3, 2, 3, 0, 1, 2, 3, 2, 3, 2, 3, 2, 3, 0, 1, 2, 3],
    [3, 2, 3, 2, 3, 0, 3, 0, 3, 2, 3, 2, 3, 2, 3, 0, 3, 0, 3, 2],
    [2, 3, 2, 1, 2, 3, 2, 3, 0, 3, 2, 3, 2, 1, 2, 3, 2, 3, 0, 3],
    [3, 0, 3, 2, 3, 2, 3, 2, 3, 0, 3, 0, 3, 2, 3, 2, 3, 2, 3, 0],
    [0, 3, 2, 3, 2, 3, 2, 3, 2, 1, 0, 3, 2, 3, 2, 3, 2, 3, 2, 1]
];

topics = [dirichlet([1, 1, 1, 1]) for k in 0..1];
fun document(words) {
  mix = dirichlet([1, 1]);
  for w in words {
    topic = categorical(mix);
    observe(Categorical(topics[topic]), w);
  }
}
for words in documents: document(words);

// Which topic is called the first is a matter of chance, so what is returned does not depend on it: how
// probable the first two words are together, in the topic that has more of them and in the other one.
low = [topics[k][0] + topics[k][1] for k in 0..1];
return max(low), min(low);
