package org.dfra.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.AbstractSet;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.junit.jupiter.api.Test;

class DeliveryPolicyTest {

  /** As it may come over the network: a set of anything. */
  @SuppressWarnings("unchecked")
  private static Set<EventKind> set(List<?> elements) {
    return (Set<EventKind>)
        (Set<?>)
            new AbstractSet<Object>() {
              @Override
              public Iterator<Object> iterator() {
                return Collections.<Object>unmodifiableList(elements).iterator();
              }

              @Override
              public int size() {
                return elements.size();
              }
            };
  }

  @Test
  void keepsTheKinds() {
    Set<EventKind> wanted = EnumSet.of(EventKind.READING, EventKind.INCIDENT);
    assertThat(new DeliveryPolicy(set(List.copyOf(wanted)), 1, 1).kinds()).isEqualTo(wanted);
  }

  @Test
  void hashesNothingElse() {
    Object bomb =
        new Object() {
          @Override
          public int hashCode() {
            throw new AssertionError("hashed");
          }
        };
    assertRefused(List.of(bomb));
    assertRefused(List.of(EventKind.READING, bomb));
  }

  @Test
  void looksAtNoMoreThanThereAreKinds() {
    assertRefused(Collections.nCopies(EventKind.values().length + 1, EventKind.READING));
  }

  private static void assertRefused(List<?> kinds) {
    assertThatThrownBy(() -> new DeliveryPolicy(set(kinds), 1, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("a listener names kinds of events, each once at the most");
  }
}
