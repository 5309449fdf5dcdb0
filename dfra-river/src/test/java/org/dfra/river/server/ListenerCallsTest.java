package org.dfra.river.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.rmi.RemoteException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleEvent;
import org.dfra.river.remote.RemoteModuleListener;
import org.junit.jupiter.api.Test;

/** What a module's calls tell a remote listener about its lease. */
class ListenerCallsTest {

  private record Call(int events, long number, long renewed) {}

  private final List<Call> received = new ArrayList<>();
  private final AtomicBoolean silent = new AtomicBoolean();
  private final AtomicBoolean isLeased = new AtomicBoolean(true);
  private final AtomicInteger renewals = new AtomicInteger();

  private final RemoteModuleListener listener =
      new RemoteModuleListener() {
        @Override
        public void notify(Delivery delivery) {
          throw new AssertionError("a call without its number");
        }

        @Override
        public void notify(Delivery delivery, long call, long renewed) throws RemoteException {
          take(new Call(1, call, renewed));
        }

        @Override
        public void notify(List<Delivery> deliveries, long call, long renewed)
            throws RemoteException {
          take(new Call(deliveries.size(), call, renewed));
        }

        private void take(Call call) throws RemoteException {
          received.add(call);
          if (silent.get()) {
            throw new RemoteException("no answer");
          }
        }
      };

  private final ListenerCalls calls =
      new ListenerCalls(
          listener,
          () -> {
            renewals.incrementAndGet();
            return isLeased.get();
          });

  private static List<Delivery> events(int count) {
    Delivery delivery =
        new Delivery("r/m", 1, 1, 0, Instant.EPOCH, new ModuleEvent.ParameterChanged("rate", "1"));
    return java.util.Collections.nCopies(count, delivery);
  }

  @Test
  void eachCallNamesTheLastOneThatRenewedTheLease() throws Exception {
    calls.notify(events(1));
    calls.notify(events(3));
    calls.notify(events(1));
    long first = received.get(0).number();
    assertThat(received)
        .containsExactly(
            new Call(1, first, first),
            new Call(3, first + 1, first),
            new Call(1, first + 2, first + 1));
    assertThat(renewals).hasValue(3);
  }

  @Test
  void aCallThatFailedRenewsNothing() throws Exception {
    calls.notify(events(1));
    silent.set(true);
    assertThatThrownBy(() -> calls.notify(events(2))).isInstanceOf(RemoteException.class);
    silent.set(false);
    calls.notify(events(1));
    long first = received.get(0).number();
    assertThat(received.get(2)).isEqualTo(new Call(1, first + 2, first));
    assertThat(renewals).as("not after the call without an answer").hasValue(2);
  }

  @Test
  void aLeaseThatHasEndedIsNotSaidToBeRenewed() throws Exception {
    isLeased.set(false);
    calls.notify(events(1));
    calls.notify(events(1));
    assertThat(received.get(1).renewed()).isEqualTo(received.get(1).number());
  }
}
