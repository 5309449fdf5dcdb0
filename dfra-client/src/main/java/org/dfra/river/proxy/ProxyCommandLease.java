package org.dfra.river.proxy;

import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.river.remote.effector.GrantedCommandLease;
import org.dfra.time.Scheduler;

/**
 * A client's command lease on a remote effector, maintained by a {@link LeaseRenewer} until it is
 * lost.
 */
public final class ProxyCommandLease implements CommandLease {

  /** Longer than a call's usual deadline of 2 s. */
  private static final Duration LONGEST_RETURN = Duration.ofSeconds(3);

  private final LeaseRenewer renewer;
  private final CommandKey key;

  private ProxyCommandLease(LeaseRenewer renewer, CommandKey key) {
    this.renewer = renewer;
    this.key = key;
  }

  /**
   * Starts to renew a lease; if it is lost, requests no other.
   *
   * @param server the effector's remote proxy, which has granted it
   * @param asked when it was requested, nanoseconds of {@link Scheduler#system}
   */
  public static CommandLease startRenewing(
      String path, GrantedCommandLease given, Remote server, Duration duration, long asked)
      throws RemoteException {
    LeaseRenewer renewer =
        new LeaseRenewer(
                "command of " + path,
                duration.toMillis(),
                PreparedProxies.lease(server, given.lease()),
                Scheduler.system())
            .requestedAt(asked);
    renewer.start();
    return new ProxyCommandLease(renewer, given.key());
  }

  @Override
  public CommandKey key() {
    return key;
  }

  @Override
  public Instant expiration() {
    return renewer.expiration();
  }

  @Override
  public boolean isLive() {
    return renewer.isLive();
  }

  /**
   * {@inheritDoc} When it returns, the effector stops and other clients may command it. If its
   * server does not answer, the lease ends when it expires.
   */
  @Override
  public void close() {
    try {
      renewer.cancel().get(LONGEST_RETURN.toMillis(), TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException | TimeoutException e) {
      // it expires
    }
  }
}
