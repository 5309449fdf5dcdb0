package java.rmi.activation;

import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.UnknownHostException;
import java.util.LinkedHashSet;
import java.util.Objects;
import java.util.Set;

/**
 * The client's half of an activatable JRMP reference. It calls the live object that it knows, and
 * activates the object when there is none or it is gone.
 *
 * <p>A call is repeated only when it certainly was not executed, so it is executed at most once.
 * Two proxies are equal when their identities are.
 */
final class ActivatableHandler implements InvocationHandler, Serializable {

  private static final long serialVersionUID = 1L;

  /** With the known proxy, with the activator's, and with one that the group has confirmed. */
  private static final int ATTEMPTS = 3;

  private final ActivationID id;

  /** The JRMP stub of the running object, or null while unknown. */
  private volatile Remote live;

  private ActivatableHandler(ActivationID id, Remote live) {
    this.id = id;
    this.live = live;
  }

  /** A proxy with every remote interface of a class; the live stub may be null. */
  static Remote proxy(ActivationID id, Class<?> implementation, Remote live) {
    return (Remote)
        Proxy.newProxyInstance(
            implementation.getClassLoader(),
            interfaces(implementation),
            new ActivatableHandler(id, live));
  }

  /** Every remote interface of a class; a class without any is refused. */
  static Class<?>[] interfaces(Class<?> implementation) {
    Set<Class<?>> interfaces = new LinkedHashSet<>();
    for (Class<?> c = implementation; c != null; c = c.getSuperclass()) {
      for (Class<?> declared : c.getInterfaces()) {
        if (Remote.class.isAssignableFrom(declared)) {
          interfaces.add(declared);
        }
      }
    }
    if (interfaces.isEmpty()) {
      throw new IllegalArgumentException(
          implementation.getName()
              + " implements no remote interface, so it cannot be called remotely.");
    }
    return interfaces.toArray(Class<?>[]::new);
  }

  @Override
  public Object invoke(Object proxy, Method method, Object[] args) throws Throwable {
    if (method.getDeclaringClass() == Object.class) {
      return switch (method.getName()) {
        case "equals" ->
            handlerOf(args[0]) instanceof ActivatableHandler that && Objects.equals(id, that.id);
        case "hashCode" -> Objects.hashCode(id);
        default -> "Activatable[" + id + ", live " + live + "]";
      };
    }
    boolean force = false;
    for (int attempt = 1; ; attempt++) {
      Remote target = live;
      if (target == null) {
        target = activate(force);
        force = true;
        live = target;
      }
      try {
        return call(target, method, args);
      } catch (RemoteException e) {
        live = null;
        if (attempt == ATTEMPTS || !notExecuted(e)) {
          throw e;
        }
      }
    }
  }

  private static boolean notExecuted(RemoteException e) {
    return e instanceof NoSuchObjectException
        || e instanceof ConnectException
        || e instanceof ConnectIOException
        || e instanceof UnknownHostException;
  }

  /** The stub of the running object, also when the activator answers with an activatable proxy. */
  private Remote activate(boolean force) throws RemoteException {
    Remote answer;
    try {
      answer = id.activate(force);
    } catch (UnknownObjectException e) {
      throw new NoSuchObjectException("The object is not registered: " + e.getMessage());
    } catch (ActivationException e) {
      throw new ActivateFailedException("The object cannot be activated", e);
    }
    Remote found = handlerOf(answer) instanceof ActivatableHandler inner ? inner.live : answer;
    if (found == null) {
      throw new ActivateFailedException("The activator answered with a proxy that is not live.");
    }
    return found;
  }

  private static InvocationHandler handlerOf(Object object) {
    return object != null && Proxy.isProxyClass(object.getClass())
        ? Proxy.getInvocationHandler(object)
        : null;
  }

  /** Through the handler where possible: reflection fails on non-public interfaces. */
  private static Object call(Remote target, Method method, Object[] args) throws Throwable {
    InvocationHandler handler = handlerOf(target);
    if (handler != null) {
      return handler.invoke(target, method, args);
    }
    try {
      return method.invoke(target, args);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }
}
