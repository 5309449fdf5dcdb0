package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/**
 * A directory compares what a module says of itself with what it said before, and its lists may
 * hold anything when they arrive. What takes for ever to walk through is refused, also where
 * nothing of it is hashed.
 */
class WalkLimitTest {

  private static final String REFUSED = " objects, each as often as it is referred to, > ";

  /** Lists that contain the one before twice: to walk through one takes 2 to its number steps. */
  private static List<Object> ladder(int count) {
    List<Object> rungs = new ArrayList<>();
    List<Object> ladder = new ArrayList<>(List.of("x"));
    for (int i = 0; i < count; i++) { // each rung is at depth 2
      rungs.add(ladder);
      ladder = new ArrayList<>(List.of(ladder, ladder));
    }
    return rungs;
  }

  @Test
  void listsThatAreSharedALittlePass() throws Exception {
    assertThat(read(ladder(16).toArray())).isNotNull();
    assertThat(read(new HashMap<>(Map.of("x", ladder(16))))).as("a value").isNotNull();
  }

  @Test
  void refusesAGraphThatGrowsByPowersWhenItIsWalkedThrough() throws Exception {
    List<Object> rungs = ladder(60);
    assertRefused(rungs.toArray());
    assertRefused(rungs);
    assertRefused(new HashMap<>(Map.of("x", rungs)));
  }

  /** A walk goes round until its stack is full, through all that is beside the cycle each time. */
  @Test
  void refusesLessWhereSomethingContainsItself() throws Exception {
    List<Object> rungs = ladder(15);
    assertThat(read(rungs.toArray())).isNotNull();
    rungs.add(rungs);
    assertRefused(rungs);
    List<Object> small = ladder(5);
    small.add(small);
    assertThat(read(small.toArray())).isNotNull();
  }

  private static void assertRefused(Object graph) throws IOException {
    byte[] bytes = Payload.bytes(graph);
    assertThatThrownBy(() -> readBytes(bytes))
        .isInstanceOf(InvalidObjectException.class)
        .hasCauseInstanceOf(RefusedDataException.class)
        .hasMessageContaining(REFUSED);
  }

  private static Object read(Object graph) throws IOException, ClassNotFoundException {
    return readBytes(Payload.bytes(graph));
  }

  private static Object readBytes(byte[] bytes) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in =
        new ObjectInputStream(
            ScannedStream.of(new ByteArrayInputStream(bytes), SerialLimits.CALL))) {
      return in.readObject();
    }
  }
}
