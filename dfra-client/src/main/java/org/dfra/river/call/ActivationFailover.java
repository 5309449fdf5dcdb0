package org.dfra.river.call;

import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Objects;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;

/**
 * Selects the proxy for each attempt of one call. Confined to the caller's thread.
 *
 * <pre>
 *   trusted proxy ---fails---&gt; activator ---answers---&gt; its proxy
 *                                  |
 *                     unreachable, or no answer for a second
 *                                  v
 *                          the last proxy again
 * </pre>
 */
final class ActivationFailover {

  /**
   * The timeout of the activator while there is another way: an unresponsive peer must be detected
   * within 3 s, of which the call by the other way may take 2.
   */
  static final Duration ACTIVATOR_TIMEOUT = Duration.ofSeconds(1);

  private final LiveProxyHolder proxies;
  private boolean force;
  private @Nullable Future<Remote> pending;
  private @Nullable ActivatorUnreachableException unreachable;

  ActivationFailover(LiveProxyHolder proxies) {
    this.proxies = proxies;
  }

  /**
   * The proxy to try first.
   *
   * @throws RemoteException if there is none; the call has not run
   */
  Remote first() throws RemoteException {
    @Nullable Remote trusted = proxies.unsuspectedOrNull();
    if (trusted != null) {
      return trusted;
    }
    @Nullable Remote doubted = proxies.last();
    Future<Remote> activation = proxies.replace(null, false);
    force = true;
    try {
      return doubted == null
          ? outcome(activation, Long.MAX_VALUE)
          : outcome(activation, ACTIVATOR_TIMEOUT.toNanos());
    } catch (TimeoutException e) {
      pending = activation;
    } catch (ActivatorUnreachableException e) {
      if (doubted == null) {
        throw e.forCaller();
      }
      unreachable = e;
    }
    return Objects.requireNonNull(doubted);
  }

  /**
   * The proxy to try next.
   *
   * @param failed the last proxy
   * @param failure its failure: the call has not run, or may be repeated
   * @throws RemoteException if there is none; it describes the activator's failure, and contains
   *     that of the attempt as a suppressed exception
   */
  Remote next(Remote failed, RemoteException failure) throws RemoteException {
    if (unreachable != null) {
      throw unreachable.forCaller(failure);
    }
    boolean triedAnyway = pending != null;
    Future<Remote> activation = triedAnyway ? pending : proxies.replace(failed, force);
    pending = null;
    force = true;
    try {
      return outcome(Objects.requireNonNull(activation), Long.MAX_VALUE);
    } catch (TimeoutException e) {
      throw new IllegalStateException("waited for centuries", e);
    } catch (ActivatorUnreachableException e) {
      if (triedAnyway || failure instanceof NoSuchObjectException) {
        throw e.forCaller(failure); // it answered and refused
      }
      unreachable = e;
      return failed; // the peer may be reachable again
    }
  }

  private static Remote outcome(Future<Remote> activation, long nanos)
      throws RemoteException, ActivatorUnreachableException, TimeoutException {
    try {
      return activation.get(nanos, TimeUnit.NANOSECONDS);
    } catch (ExecutionException e) {
      Throwable cause = e.getCause();
      if (cause instanceof ActivatorUnreachableException silent) {
        throw silent;
      } else if (cause instanceof RemoteException refused) {
        throw refused;
      } else if (cause instanceof RuntimeException mistake) {
        throw mistake;
      }
      throw new IllegalStateException("an activation failed in an unforeseen way", cause);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CallInterruptedException("the activation of the object", false);
    }
  }
}
