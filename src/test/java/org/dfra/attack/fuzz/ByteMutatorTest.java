package org.dfra.attack.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ByteMutatorTest {

  private static final String HOST = "127.0.0.1";
  private static final byte[] VALID =
      ("host " + HOST + " port 4160 group team").getBytes(StandardCharsets.US_ASCII);
  private static final int TIMES = 2_000;

  @Test
  void changesAlmostEveryMessageAndLeavesTheOriginal() {
    ByteMutator mutator = new ByteMutator(new Random(1), List.of());
    byte[] original = VALID.clone();
    Set<String> results = new HashSet<>();
    for (int i = 0; i < TIMES; i++) {
      results.add(text(mutator.mutate(original)));
    }
    assertThat(original).isEqualTo(VALID);
    assertThat(results).hasSizeGreaterThan(TIMES * 8 / 10); // two flips may undo each other
  }

  @Test
  void doesTheSameWithTheSameSeed() {
    ByteMutator one = new ByteMutator(new Random(7), List.of(HOST));
    ByteMutator other = new ByteMutator(new Random(7), List.of(HOST));
    for (int i = 0; i < TIMES; i++) {
      assertThat(one.mutate(VALID)).isEqualTo(other.mutate(VALID));
    }
  }

  /** It may vanish as a whole, and be there more than once. */
  @Test
  void neverSplitsWhatIsKept() {
    ByteMutator mutator = new ByteMutator(new Random(3), List.of(HOST));
    for (int i = 0; i < TIMES; i++) {
      String mutated = text(mutator.mutate(VALID));
      String rest = mutated.replace(HOST, "");
      assertThat(rest).doesNotContain("127.").doesNotContain("0.0.1");
    }
  }

  @Test
  void staysWithinADatagram() {
    ByteMutator mutator = new ByteMutator(new Random(4), List.of());
    byte[] bytes = VALID;
    for (int i = 0; i < TIMES; i++) {
      bytes = mutator.mutate(bytes);
      assertThat(bytes.length).isLessThan(65_507);
      bytes = bytes.length == 0 ? VALID : bytes;
    }
  }

  private static String text(byte[] bytes) {
    return new String(bytes, StandardCharsets.ISO_8859_1);
  }
}
