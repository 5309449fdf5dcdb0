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
 * A server's grant to a listener: its lease, and the sequence numbers at which its events begin. It
 * neither renews the lease nor counts events; the client's proxy does.
 */
public final class GrantedSubscription implements Subscription, Serializable {

  /** The serial form of the former record. */
  @Serial private static final long serialVersionUID = 0;

  private final Lease lease;
  private final long epoch;
  private final List<Long> numbers;
  private final transient MonotonicLease span;

  /**
   * @param lease the registration ends when it expires
   * @param epoch the module's epoch when the listener was registered
   * @param numbers the last number of each kind of event by then, by ordinal
   */
  public GrantedSubscription(Lease lease, long epoch, List<Long> numbers) {
    this(lease, epoch, numbers, InstantSource.system(), System::nanoTime);
  }

  /** For tests, with another clock. */
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

  /** Validates the received data, and converts the lease to a duration on this computer. */
  @Serial
  private Object readResolve() {
    return new GrantedSubscription(lease, epoch, numbers);
  }

  /** The lease, for its renewal. */
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

  /** {@inheritDoc} If the server cannot be reached, the subscription ends with its lease. */
  @Override
  public void close() {
    try {
      lease.cancel();
    } catch (UnknownLeaseException | RemoteException e) {
      // it has ended, or will expire
    }
  }
}
