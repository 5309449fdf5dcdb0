package org.dfra.river.remote;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Instant;
import java.util.AbstractList;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleEvent;
import org.junit.jupiter.api.Test;

/** The events of one call, as any program may send them. */
class DeliveryListTest {

  private final List<Long> received = new ArrayList<>();

  private static Delivery delivery(long number) {
    return new Delivery(
        "r/m", 1, number, 0, Instant.EPOCH, new ModuleEvent.ParameterChanged("rate", "1"));
  }

  @Test
  void refusesWhatIsNoListOfEvents() {
    List<Object> foreign =
        new AbstractList<>() {
          @Override
          public Object get(int index) {
            throw new AssertionError("the code of another program's list ran");
          }

          @Override
          public int size() {
            throw new AssertionError("the code of another program's list ran");
          }
        };
    for (List<?> each :
        Arrays.<List<?>>asList(
            null,
            foreign,
            List.of(),
            List.of("no event"),
            Arrays.asList(delivery(1), null),
            Collections.nCopies(65, delivery(1)))) {
      assertThatIllegalArgumentException().isThrownBy(() -> DeliveryList.checked(each));
    }
    assertThat(DeliveryList.checked(Arrays.asList(delivery(1), delivery(2)))).hasSize(2);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> DeliveryList.checked(Collections.nCopies(65, delivery(1))))
        .withMessage("65 events in one call are outside 1 to 64; send them in several calls");
  }

  @Test
  void aListenerThatThrowsGetsTheRestAndTheServerAnException() {
    RemoteModuleListener listener =
        delivery -> {
          received.add(delivery.sequence());
          if (delivery.sequence() < 3) {
            throw new IllegalStateException("at " + delivery.sequence());
          }
        };
    assertThatThrownBy(() -> listener.notify(List.of(delivery(1), delivery(2), delivery(3)), 1, 1))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("at 1")
        .satisfies(e -> assertThat(e.getSuppressed()[0]).hasMessage("at 2"));
    assertThat(received).containsExactly(1L, 2L, 3L);
  }
}
