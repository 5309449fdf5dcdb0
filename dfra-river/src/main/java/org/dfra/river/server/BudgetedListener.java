package org.dfra.river.server;

import java.net.InetAddress;
import java.rmi.RemoteException;
import java.rmi.server.ServerNotActiveException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.IntSupplier;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;
import net.jini.export.ServerContext;
import org.dfra.core.budget.BudgetExceededException;
import org.dfra.core.budget.ListenerShare;
import org.dfra.event.Delivery;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.delivery.BatchListener;
import org.dfra.river.access.RemoteCaller;
import org.dfra.river.security.SecureProcess;
import org.dfra.river.security.budget.ProcessBudgets;
import org.dfra.river.transport.TransportTraffic;
import org.dfra.security.Caller;
import org.jspecify.annotations.Nullable;

/**
 * A remote listener that gets fewer readings while the radio's rate is reached, or while a budget
 * has no bytes left for it: of the radio's every n-th one, but one in a second if the module has
 * one. The others count as dropped. It gets every other event, such as a change of readiness.
 *
 * <p>Confined to the listener's queue, which makes one call at a time.
 */
final class BudgetedListener implements BatchListener {

  private static final long SECOND = TimeUnit.SECONDS.toNanos(1);

  private final BatchListener listener;
  private final ListenerShare share;
  private final IntSupplier radio;
  private final LongConsumer notSent;
  private final LongSupplier nanos;
  private long count;
  private long dropped;
  private long lastReading;
  private boolean any; // whether a reading was sent

  /**
   * @param share what it may use
   * @param radio the n of which every n-th reading is sent
   * @param notSent counts readings that are not sent because of it
   * @param nanos a monotonic clock in nanoseconds
   */
  BudgetedListener(
      BatchListener listener,
      ListenerShare share,
      IntSupplier radio,
      LongConsumer notSent,
      LongSupplier nanos) {
    this.listener = listener;
    this.share = share;
    this.radio = radio;
    this.notSent = notSent;
    this.nanos = nanos;
  }

  /**
   * Admits a listener of the current call's client.
   *
   * @param object the module that it listens to
   * @return empty if this process has no budgets, or the call comes from this process
   * @throws BudgetExceededException if a budget allows no further listener
   */
  static Optional<ListenerShare> admit(String object) throws BudgetExceededException {
    Optional<ProcessBudgets> budgets = SecureProcess.budgets();
    Optional<Caller> caller = currentCaller();
    return budgets.isEmpty() || caller.isEmpty()
        ? Optional.empty()
        : Optional.of(budgets.get().guard().admitListener(caller.get(), object));
  }

  private static Optional<Caller> currentCaller() {
    try {
      for (Object each : ServerContext.getServerContext()) {
        if (each instanceof Caller caller) {
          return Optional.of(caller);
        }
      }
    } catch (ServerNotActiveException e) {
      return Optional.empty(); // a caller in this virtual machine
    }
    return Optional.empty();
  }

  /**
   * Whether events to an address leave the computer that has another one. Looks up no name: the
   * listener's client has chosen it.
   */
  static boolean leavesComputer(String listener, String own) {
    @Nullable InetAddress to = RemoteCaller.fromHost(listener).address();
    @Nullable InetAddress here = RemoteCaller.fromHost(own).address();
    boolean isHere = to != null && (to.equals(here) || to.equals(InetAddress.getLoopbackAddress()));
    return !isHere && !listener.equals(own);
  }

  @Override
  public void notify(List<Delivery> deliveries) throws RemoteException {
    int oneIn = radio.getAsInt();
    boolean isCounted = share.isCounted();
    boolean isOut = isCounted && share.isOutOfBytes();
    long before = isCounted ? TransportTraffic.bytesOfThread() : 0;
    long thinned = 0;
    try {
      if (oneIn == 1 && !isOut && dropped == 0) {
        noteReading(deliveries);
        listener.notify(deliveries);
        return;
      }
      List<Delivery> kept = new ArrayList<>(deliveries.size());
      for (Delivery each : deliveries) {
        if (each.kind() == EventKind.READING && isThinned(oneIn, isOut)) {
          dropped += 1 + each.dropped();
          thinned++;
        } else {
          kept.add(each.afterDropping(dropped));
          dropped = 0;
        }
      }
      if (!kept.isEmpty()) {
        listener.notify(List.copyOf(kept));
      }
    } finally {
      if (isCounted) {
        share.count(TransportTraffic.bytesOfThread() - before, thinned);
      }
      if (thinned > 0 && oneIn > 1) {
        notSent.accept(thinned);
      }
    }
  }

  private boolean isThinned(int oneIn, boolean isOut) {
    long now = nanos.getAsLong();
    count++;
    boolean isDue = !any || now - lastReading >= SECOND || (!isOut && count % oneIn == 0);
    if (isDue) {
      any = true;
      lastReading = now;
    }
    return !isDue;
  }

  private void noteReading(List<Delivery> deliveries) {
    for (Delivery each : deliveries) {
      if (each.kind() == EventKind.READING) {
        any = true;
        lastReading = nanos.getAsLong();
        return;
      }
    }
  }
}
