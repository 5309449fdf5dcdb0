package org.dfra.river.remote;

import java.io.Serializable;
import java.rmi.RemoteException;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import net.jini.core.lease.Lease;
import net.jini.core.lease.UnknownLeaseException;
import org.dfra.event.DeliveryPolicy.Kind;
import org.dfra.event.Subscription;

/**
 * What a server gives for a listener: its lease, and where its events begin. It neither renews
 * itself nor counts; the client's proxy does.
 *
 * @param lease ends the registration unless it is renewed
 * @param epoch the module's epoch when the listener was registered
 * @param numbers the last number of each kind of event by then, by ordinal
 */
public record LeasedSubscription(Lease lease, long epoch, List<Long> numbers)
    implements Subscription, Serializable {

  public LeasedSubscription {
    numbers = List.copyOf(numbers);
    if (numbers.size() != Kind.values().length) {
      throw new IllegalArgumentException(
          "a subscription that numbers "
              + numbers.size()
              + " kinds of events, where there are "
              + Kind.values().length);
    }
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
    return lease.getExpiration() > System.currentTimeMillis();
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
