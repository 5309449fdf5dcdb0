package org.dfra.core.module;

import java.time.Instant;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.dfra.event.Subscription;
import org.dfra.event.delivery.DeliveryCounter;

/** The subscription of a listener in the module's own virtual machine. */
final class LocalSubscription implements Subscription {

  private final DeliveryCounter tally;
  private final BooleanSupplier held;
  private final Runnable end;
  private final AtomicBoolean closed = new AtomicBoolean();

  /**
   * @param held whether the listener's lease is still live
   * @param end run once when it is closed
   */
  LocalSubscription(DeliveryCounter tally, BooleanSupplier held, Runnable end) {
    this.tally = tally;
    this.held = held;
    this.end = end;
  }

  @Override
  public long received() {
    return tally.received();
  }

  @Override
  public long lost() {
    return tally.lost();
  }

  @Override
  public Optional<Instant> interruptedSince() {
    return Optional.empty();
  }

  @Override
  public boolean isOpen() {
    return !closed.get() && held.getAsBoolean();
  }

  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      end.run();
    }
  }
}
