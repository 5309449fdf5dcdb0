package org.dfra.river.call;

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
import java.rmi.activation.ActivationID;
import java.util.Objects;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.security.proxytrust.TrustEquivalence;
import org.dfra.module.Idempotent;
import org.jspecify.annotations.Nullable;

/**
 * Calls an activatable object, and activates it again if it has ended.
 *
 * <p>It calls the live proxy. If the object is certainly not there (no such object, no connection,
 * unknown host), it requests a new live proxy from the activator and tries again, three times in
 * all, and with force from the second time on. A call that was cut off may have run. It is repeated
 * once if its method is {@link Idempotent}; otherwise the caller gets the failure (at most once). A
 * call that exceeded its deadline is never repeated: the caller has waited long enough. The next
 * call contacts the activator first.
 *
 * <p>If the activator is unreachable too, or does not answer for a second, the last live proxy is
 * tried once more. So a robot continues to work when its activation daemon has ended, and after a
 * short link failure. A call that may have run is never sent twice, unless it is idempotent.
 *
 * <p>Callers that share a proxy share one activation: they wait for it together and get the same
 * outcome. So an unresponsive activator costs each of them one deadline, not one after the other.
 */
public final class ResurrectingHandler
    implements InvocationHandler, TrustEquivalence, Serializable {

  private static final long serialVersionUID = 1L;

  private static final int ATTEMPTS = 3;

  private final ActivationID id;
  private final @Nullable MethodConstraints constraints;
  private final transient LiveProxyHolder proxies;

  ResurrectingHandler(ActivationID id, @Nullable Remote live) {
    this(id, LiveProxyHolder.constrain(live, null), null);
  }

  private ResurrectingHandler(
      ActivationID id, @Nullable Remote live, @Nullable MethodConstraints constraints) {
    this.id = id;
    this.constraints = constraints;
    this.proxies = new LiveProxyHolder(id, live, constraints);
  }

  /** The identifier under which the activation system knows the object. */
  public ActivationID activationID() {
    return id;
  }

  /** The last proxy that reached the object, or null. */
  public @Nullable Remote live() {
    return proxies.last();
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
    boolean repeatable = method.isAnnotationPresent(Idempotent.class);
    ActivationFailover search = new ActivationFailover(proxies);
    Remote target = search.first();
    for (int attempt = 1; ; attempt++) {
      RemoteException failure;
      try {
        return reach(target, method, args);
      } catch (NoSuchObjectException
          | ConnectException
          | ConnectIOException
          | UnknownHostException e) {
        failure = e; // it has not run
      } catch (MarshalException | ServerError | ServerException e) {
        throw e;
      } catch (CallInterruptedException e) {
        throw e; // neither a fault of the object nor repeatable
      } catch (DeadlineExceededException e) {
        proxies.suspect(target);
        throw e;
      } catch (RemoteException e) {
        if (!repeatable) {
          proxies.suspect(target);
          throw e;
        }
        repeatable = false; // once is enough
        failure = e;
      }
      if (attempt == ATTEMPTS) {
        proxies.suspect(target);
        throw failure;
      }
      target = search.next(target, failure);
    }
  }

  private @Nullable Object reach(Remote target, Method method, Object @Nullable [] args)
      throws Throwable {
    boolean reached = true;
    try {
      return invokeOn(target, method, args);
    } catch (RemoteException e) {
      reached = false;
      throw e;
    } finally {
      if (reached) { // an exception of the object itself is a response too
        proxies.confirm(target);
      }
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

  private Object constrained(Object proxy, @Nullable MethodConstraints wanted) {
    Class<?> type = proxy.getClass();
    return Proxy.newProxyInstance(
        type.getClassLoader(),
        type.getInterfaces(),
        new ResurrectingHandler(id, LiveProxyHolder.constrain(live(), wanted), wanted));
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

  private Object writeReplace() {
    return new Form(id, live(), constraints);
  }

  private void readObject(ObjectInputStream in) throws InvalidObjectException {
    throw new InvalidObjectException("a handler of this kind is written as its form");
  }

  /** The serial form: it includes the last proxy, for a client that cannot reach the activator. */
  private record Form(
      ActivationID id, @Nullable Remote live, @Nullable MethodConstraints constraints)
      implements Serializable {

    Form {
      Objects.requireNonNull(id, "activation ID");
    }

    private Object readResolve() {
      return new ResurrectingHandler(id, live, constraints);
    }
  }
}
