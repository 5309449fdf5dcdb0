package org.dfra.river.call;

import java.io.IOException;
import java.io.InvalidObjectException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.MarshalException;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.ServerError;
import java.rmi.ServerException;
import java.rmi.UnknownHostException;
import java.rmi.activation.ActivateFailedException;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;
import java.util.Objects;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicReference;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.security.proxytrust.TrustEquivalence;
import org.dfra.module.Idempotent;
import org.jspecify.annotations.Nullable;

/**
 * Invokes an activatable object and brings it back when it is dead.
 *
 * <p>It calls the live proxy. Where the object is certainly not there (no such object, no
 * connection, unknown host) it asks the activator for a new live proxy and tries again, three times
 * in all, and from the second time on with force. A call that broke off on its way may have run: it
 * is repeated, once, where its method is {@link Idempotent}, and reaches the caller as a failure
 * where it is not (at most once). A call that met its deadline is never repeated: the caller has
 * waited long enough.
 *
 * <p>Callers that share a proxy share one activation: they wait for it together and get the same
 * outcome, so a silent activator costs each of them one deadline, not one after the other.
 */
public final class ResurrectingHandler
    implements InvocationHandler, TrustEquivalence, Serializable {

  private static final long serialVersionUID = 1L;

  private static final int ATTEMPTS = 3;

  private final ActivationID id;
  private final @Nullable MethodConstraints constraints;
  private @Nullable Remote live; // guarded by this
  private transient @Nullable Activation activation; // guarded by this

  ResurrectingHandler(ActivationID id, @Nullable Remote live) {
    this(id, constrain(live, null), null);
  }

  private ResurrectingHandler(
      ActivationID id, @Nullable Remote live, @Nullable MethodConstraints constraints) {
    this.id = id;
    this.live = live;
    this.constraints = constraints;
  }

  /** The identifier under which the activation system knows the object. */
  public ActivationID activationID() {
    return id;
  }

  /** The proxy that was last known to reach the object, or null. */
  public synchronized @Nullable Remote live() {
    return live;
  }

  @Override
  public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] args)
      throws Throwable {
    Class<?> declarer = method.getDeclaringClass();
    if (declarer == Object.class) {
      return objectMethod(proxy, method, args);
    } else if (declarer == RemoteMethodControl.class) {
      return method.getName().equals("getConstraints")
          ? constraints
          : constrained(proxy, args == null ? null : (MethodConstraints) args[0]);
    } else if (declarer == TrustEquivalence.class) {
      return args != null
          && args[0] != null
          && handlerOf(args[0]) instanceof ResurrectingHandler other
          && checkTrustEquivalence(other);
    }
    return call(method, args);
  }

  private @Nullable Object call(Method method, Object @Nullable [] args) throws Throwable {
    boolean force = false;
    boolean repeatable = method.isAnnotationPresent(Idempotent.class);
    @Nullable Remote target = live();
    if (target == null) {
      target = activate(null, force);
      force = true;
    }
    for (int attempt = 1; ; attempt++) {
      try {
        return invokeOn(target, method, args);
      } catch (NoSuchObjectException
          | ConnectException
          | ConnectIOException
          | UnknownHostException e) {
        if (attempt == ATTEMPTS) {
          throw e;
        }
      } catch (MarshalException | ServerError | ServerException e) {
        throw e;
      } catch (CallInterruptedException e) {
        throw e; // neither the object's fault nor to be repeated
      } catch (DeadlineExceededException e) {
        forget(target);
        throw e;
      } catch (RemoteException e) {
        if (!repeatable || attempt == ATTEMPTS) {
          forget(target);
          throw e;
        }
        repeatable = false; // once is enough
      }
      target = activate(target, force);
      force = true;
    }
  }

  private static @Nullable Object invokeOn(Remote target, Method method, Object @Nullable [] args)
      throws Throwable {
    if (Proxy.isProxyClass(target.getClass())) {
      // Not by reflection: the method's interface may be package-private to River.
      return Proxy.getInvocationHandler(target).invoke(target, method, args);
    }
    try {
      return method.invoke(target, args);
    } catch (InvocationTargetException e) {
      throw Objects.requireNonNull(e.getCause());
    }
  }

  private synchronized void forget(Remote dead) {
    if (dead.equals(live)) {
      live = null;
    }
  }

  /** An activation that is under way, and whether it was asked for with force. */
  private record Activation(FutureTask<Remote> task, boolean force) {}

  /**
   * The live proxy that replaces {@code dead}: one that another caller got, or a new one.
   *
   * <p>The activation runs on a thread of its own, so that none of those who wait for it can spoil
   * it for the others by being interrupted.
   */
  private Remote activate(@Nullable Remote dead, boolean force) throws Exception {
    Activation shared;
    synchronized (this) {
      if (live != null && !live.equals(dead)) {
        return live;
      }
      // One without force may bring the same dead proxy again, so it is no help to who needs force.
      if (activation == null || (force && !activation.force())) {
        activation = begin(force);
      }
      shared = activation;
    }
    try {
      return shared.task().get();
    } catch (ExecutionException e) {
      Throwable cause = e.getCause();
      if (cause instanceof Exception failure) {
        throw failure;
      }
      throw e;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CallInterruptedException("activating " + id, false);
    }
  }

  private Activation begin(boolean force) {
    AtomicReference<@Nullable Activation> self = new AtomicReference<>();
    Activation begun = new Activation(new FutureTask<>(() -> bringBack(force, self)), force);
    self.set(begun);
    CallThreads.run(begun.task());
    return begun;
  }

  /** Asks the activator; what it answers counts before the activation is over. */
  private Remote bringBack(boolean force, AtomicReference<@Nullable Activation> self)
      throws RemoteException {
    @Nullable Remote found = null;
    try {
      found = askActivator(force);
      return found;
    } finally {
      synchronized (this) {
        if (activation == self.get()) {
          activation = null;
          live = found != null ? found : live;
        }
      }
    }
  }

  private Remote askActivator(boolean force) throws RemoteException {
    try {
      Remote proxy = id.activate(force);
      if (!(handlerOf(proxy) instanceof ResurrectingHandler handler)) {
        throw new ActivateFailedException(
            "the object came back without a resurrecting proxy; export it with "
                + ResurrectingExporter.class.getSimpleName());
      }
      if (!id.equals(handler.id)) {
        throw new ActivateFailedException("the object came back under another activation ID");
      }
      @Nullable Remote found = handler.live();
      if (found == null) {
        throw new ActivateFailedException("the object came back without a live proxy");
      }
      return Objects.requireNonNull(constrain(found, constraints));
    } catch (UnknownObjectException e) {
      NoSuchObjectException gone =
          new NoSuchObjectException("the activation system does not know the object any more");
      gone.detail = e; // a RemoteException takes no cause by initCause
      throw gone;
    } catch (ActivationException e) {
      throw new ActivateFailedException("the object could not be activated", e);
    } catch (ActivateFailedException e) {
      throw e;
    } catch (ConnectException e) {
      throw new ConnectException("the activation system cannot be reached", e);
    } catch (RemoteException e) {
      throw new ConnectIOException("the activation system did not answer", e);
    }
  }

  private Object constrained(Object proxy, @Nullable MethodConstraints wanted) {
    Class<?> type = proxy.getClass();
    return Proxy.newProxyInstance(
        type.getClassLoader(),
        type.getInterfaces(),
        new ResurrectingHandler(id, constrain(live(), wanted), wanted));
  }

  private static @Nullable Remote constrain(
      @Nullable Remote proxy, @Nullable MethodConstraints wanted) {
    return proxy instanceof RemoteMethodControl control
        ? (Remote) control.setConstraints(wanted)
        : proxy;
  }

  private Object objectMethod(Object proxy, Method method, Object @Nullable [] args) {
    return switch (method.getName()) {
      case "hashCode" -> hashCode();
      case "equals" ->
          args != null
              && args[0] != null
              && proxy.getClass() == args[0].getClass()
              && equals(handlerOf(args[0]));
      default -> "Proxy[" + proxy.getClass().getInterfaces()[0].getSimpleName() + "," + this + "]";
    };
  }

  private static @Nullable InvocationHandler handlerOf(Object object) {
    return Proxy.isProxyClass(object.getClass()) ? Proxy.getInvocationHandler(object) : null;
  }

  @Override
  public boolean checkTrustEquivalence(@Nullable Object other) {
    return other instanceof ResurrectingHandler handler
        && Objects.equals(constraints, handler.constraints)
        && id instanceof TrustEquivalence trusted
        && trusted.checkTrustEquivalence(handler.id);
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof ResurrectingHandler handler
        && id.equals(handler.id)
        && Objects.equals(constraints, handler.constraints);
  }

  @Override
  public int hashCode() {
    return id.hashCode();
  }

  @Override
  public String toString() {
    return "ResurrectingHandler[" + id + "]";
  }

  private void readObject(ObjectInputStream in) throws IOException, ClassNotFoundException {
    in.defaultReadObject();
    if (id == null) {
      throw new InvalidObjectException("no activation ID");
    }
  }
}
