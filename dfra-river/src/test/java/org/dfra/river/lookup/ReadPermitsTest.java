package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A few read at a time, and nobody is forgotten. */
class ReadPermitsTest {

  private final ReadPermits permits = new ReadPermits(2, 2);
  private final List<String> granted = new ArrayList<>();

  private boolean acquire(String reader) {
    return acquire(permits, reader, "one address");
  }

  private boolean acquire(ReadPermits from, String reader, String origin) {
    return from.acquire(reader, origin, () -> granted.add(reader));
  }

  @Test
  void leaveSomeForOtherAddresses() {
    ReadPermits three = new ReadPermits(3, 2);
    assertThat(acquire(three, "a", "stranger")).isTrue();
    assertThat(acquire(three, "b", "stranger")).isTrue();
    assertThat(acquire(three, "c", "stranger")).isFalse();
    assertThat(acquire(three, "d", "robot")).isTrue();
    assertThat(acquire(three, "e", "robot")).isFalse();
    three.release("d");
    assertThat(granted).as("not the stranger, who came first").containsExactly("e");
    three.release("a");
    assertThat(granted).containsExactly("e", "c");
  }

  @Test
  void areGrantedInOrder() {
    assertThat(acquire("a")).isTrue();
    assertThat(acquire("b")).isTrue();
    assertThat(acquire("a")).as("it has one").isTrue();
    assertThat(acquire("c")).isFalse();
    assertThat(acquire("d")).isFalse();
    assertThat(acquire("c")).as("once more").isFalse();
    permits.release("b");
    assertThat(granted).containsExactly("c");
    assertThat(acquire("c")).isTrue();
    assertThat(acquire("b")).as("at the end of the queue").isFalse();
    permits.release("a");
    permits.release("c");
    assertThat(granted).containsExactly("c", "d", "b");
  }

  @Test
  void goToTheNextIfOneEndsBeforeItUsesItsPermit() {
    acquire("a");
    acquire("b");
    acquire("c");
    acquire("d");
    permits.release("c"); // while it waits
    permits.release("a");
    assertThat(granted).containsExactly("d");
    acquire("e");
    permits.release("d"); // unused
    assertThat(granted).containsExactly("d", "e");
    permits.release("nobody");
    permits.release("b");
    permits.release("e");
    assertThat(acquire("f")).isTrue();
    assertThat(acquire("g")).isTrue();
  }
}
