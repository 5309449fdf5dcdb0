package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
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

  /** What its local class may lack a field of, so that the walk does not go round. */
  private static final class Knot implements Serializable {
    private static final long serialVersionUID = 1L;

    final Object[] below = new Object[10];
    @Nullable Knot around; // in the stream after what is below
  }

  /** Each object is inside the one that it refers to, so that nobody knows yet what that costs. */
  @Test
  void refusesReferencesToWhatIsNotReadToItsEnd() throws Exception {
    Knot first = new Knot();
    Knot last = first;
    for (int i = 0; i < 9; i++) {
      Knot next = new Knot();
      Arrays.fill(next.below, last);
      last.around = next;
      last = next;
    }
    assertRefused(first);
  }

  /** An exception is its own cause, and a child may know its parent. */
  @Test
  void aReferenceBackToItselfOrToAParentPasses() throws Exception {
    Knot parent = new Knot();
    parent.around = new Knot();
    parent.around.below[0] = parent;
    assertThat(read(new Object[] {parent, new IllegalStateException("a", new IOException("b"))}))
        .isNotNull();
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
