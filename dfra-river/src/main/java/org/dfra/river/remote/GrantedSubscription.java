package org.dfra.river.remote;

import java.io.Serial;
import java.io.Serializable;
import java.rmi.RemoteException;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.LongSupplier;
import net.jini.core.lease.Lease;
import net.jini.core.lease.UnknownLeaseException;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.Subscription;

/**
 * What a server gives for a listener: its lease, and where its events begin. It neither renews
 * itself nor counts; the client's proxy does.
 */
public final class GrantedSubscription implements Subscription, Serializable {

  /** Of the record that this was once. */
  @Serial private static final long serialVersionUID = 0;

  private final Lease lease;
  private final long epoch;
  private final List<Long> numbers;
  private final transient MonotonicLease span;

  /**
   * @param lease ends the registration unless it is renewed
   * @param epoch the module's epoch when the listener was registered
   * @param numbers the last number of each kind of event by then, by ordinal
   */
  public GrantedSubscription(Lease lease, long epoch, List<Long> numbers) {
    this(lease, epoch, numbers, InstantSource.system(), System::nanoTime);
  }

  /** For tests: by another time. */
  GrantedSubscription(
      Lease lease, long epoch, List<Long> numbers, InstantSource clock, LongSupplier nanos) {
    this.lease = Objects.requireNonNull(lease, "lease");
    this.epoch = epoch;
    this.numbers = List.copyOf(numbers);
    if (numbers.size() != EventKind.values().length) {
      throw new IllegalArgumentException(
          "a subscription that numbers "
              + numbers.size()
              + " kinds of events, where there are "
              + EventKind.values().length);
    }
    this.span = new MonotonicLease(lease, clock, nanos);
  }

  /** Checks what has arrived, and turns the lease into a span of this computer's time. */
  @Serial
  private Object readResolve() {
    return new GrantedSubscription(lease, epoch, numbers);
  }

  /** The lease, for who renews it. */
  public Lease lease() {
    return lease;
  }

  /** The module's epoch when the listener was registered. */
  public long epoch() {
    return epoch;
  }

  /** The last number of each kind of event by then, by ordinal. */
  public List<Long> sequenceNumbers() {
    return numbers;
  }

  /** {@inheritDoc} Not counted here. */
  @Override
  public long received() {
    return 0;
  }

  /** {@inheritDoc} Not counted here. */
  @Override
  public long lost() {
    return 0;
  }

  /** {@inheritDoc} Not known here. */
  @Override
  public Optional<Instant> interruptedSince() {
    return Optional.empty();
  }

  /** {@inheritDoc} As far as is known here. */
  @Override
  public boolean isOpen() {
    return span.isLive();
  }

  /** {@inheritDoc} Where the server cannot be reached, it ends with its lease. */
  @Override
  public void close() {
    try {
      lease.cancel();
    } catch (UnknownLeaseException | RemoteException e) {
      // it has ended, or will
    }
  }
}
