package org.dfra.river.call;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.reflect.Proxy;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.activation.ActivateFailedException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import org.dfra.river.identity.CurrentIdentity;
import org.jspecify.annotations.Nullable;

/**
 * The proxy that last reached an activatable object, and its replacement.
 *
 * <p>A proxy that failed is suspected but kept: if the activator is unreachable, it is the only
 * one. Callers share one activation: they wait for it together and get the same outcome.
 */
final class LiveProxyHolder {

  private final ActivationID id;
  private final @Nullable MethodConstraints constraints;

  /** The new proxy keeps the identity of the first. */
  private final CurrentIdentity.Kept identity = CurrentIdentity.keep();

  @GuardedBy("this")
  private @Nullable Remote last;

  @GuardedBy("this")
  private boolean suspected;

  @GuardedBy("this")
  private @Nullable Activation activation;

  LiveProxyHolder(ActivationID id, @Nullable Remote last, @Nullable MethodConstraints constraints) {
    this.id = id;
    this.last = last;
    this.constraints = constraints;
  }

  /** The last proxy, suspected or not, or null. */
  synchronized @Nullable Remote last() {
    return last;
  }

  /** The last proxy, or null if it is suspected. */
  synchronized @Nullable Remote unsuspectedOrNull() {
    return suspected ? null : last;
  }

  /** Records that the object could not be reached by this proxy, and may have ended. */
  synchronized void suspect(Remote proxy) {
    if (proxy.equals(last)) {
      suspected = true;
    }
  }

  /** Records that the object was reached by this proxy. */
  synchronized void confirm(Remote proxy) {
    if (suspected && proxy.equals(last)) {
      suspected = false;
    }
  }

  /** A running activation, and whether it was requested with force. */
  private record Activation(FutureTask<Remote> task, boolean force) {}

  /**
   * Obtains a proxy that replaces {@code dead}: from another caller, or from the activator. The
   * activation runs on its own thread, so that the interruption of one waiting caller does not
   * affect the others.
   *
   * @param dead the failed proxy; null if none was tried
   * @param force whether the activator must ask the object's group even if it knows a proxy
   * @return fails with an {@link ActivatorUnreachableException}, or with a {@link RemoteException}
   *     that gives the reason why the object cannot be activated
   */
  synchronized Future<Remote> replace(@Nullable Remote dead, boolean force) {
    if (last != null && !suspected && !last.equals(dead)) {
      return CompletableFuture.completedFuture(last);
    }
    // Without force the activation may return the same dead proxy, which does not help a caller
    // that needs force.
    if (activation == null || (force && !activation.force())) {
      activation = begin(force);
    }
    return activation.task();
  }

  private Activation begin(boolean force) {
    AtomicReference<@Nullable Activation> self = new AtomicReference<>();
    Activation begun =
        new Activation(new FutureTask<>(() -> identity.call(() -> bringBack(force, self))), force);
    self.set(begun);
    CallThreads.run(begun.task());
    return begun;
  }

  /** Calls the activator; stores its answer before the activation ends. */
  private Remote bringBack(boolean force, AtomicReference<@Nullable Activation> self)
      throws RemoteException, ActivatorUnreachableException {
    @Nullable Remote found = null;
    try {
      found = askActivator(force);
      return found;
    } finally {
      synchronized (this) {
        if (activation == self.get()) {
          activation = null;
          if (found != null) {
            last = found;
            suspected = false;
          }
        }
      }
    }
  }

  private Remote askActivator(boolean force) throws RemoteException, ActivatorUnreachableException {
    try {
      return liveProxyOf(id.activate(force));
    } catch (UnknownObjectException e) {
      NoSuchObjectException gone =
          new NoSuchObjectException("the activation system does not know the object any more");
      gone.detail = e; // a RemoteException does not accept a cause by initCause
      throw gone;
    } catch (ActivationException e) {
      throw new ActivateFailedException("the object could not be activated", e);
    } catch (ActivateFailedException e) {
      throw e;
    } catch (RemoteException e) {
      throw new ActivatorUnreachableException(e);
    }
  }

  private Remote liveProxyOf(Remote activated) throws ActivateFailedException {
    if (!(Proxy.isProxyClass(activated.getClass())
        && Proxy.getInvocationHandler(activated) instanceof ResurrectingHandler handler)) {
      throw new ActivateFailedException(
          "the object came back without a resurrecting proxy; export it with "
              + ResurrectingExporter.class.getSimpleName());
    }
    if (!id.equals(handler.activationID())) {
      throw new ActivateFailedException("the object came back under another activation ID");
    }
    @Nullable Remote found = handler.live();
    if (found == null) {
      throw new ActivateFailedException("the object came back without a live proxy");
    }
    return Objects.requireNonNull(constrain(found, constraints));
  }

  /** The same proxy under these client constraints, if it accepts any. */
  static @Nullable Remote constrain(@Nullable Remote proxy, @Nullable MethodConstraints wanted) {
    return proxy instanceof RemoteMethodControl control
        ? (Remote) control.setConstraints(wanted)
        : proxy;
  }
}
