package org.dfra.river.call;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.rmi.Remote;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.time.Duration;
import net.jini.core.constraint.MethodConstraints;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.ObjectEndpoint;
import net.jini.jeri.tcp.TcpEndpoint;
import org.dfra.river.transport.TransportEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * Proxies of objects in other processes that are called back from here, such as listeners. Their
 * proxies were created elsewhere, so only the object's address is taken from them, and not the way
 * they make calls.
 */
public final class CallbackProxies {

  /** The default timeout of a callback. */
  public static final Duration DEADLINE = DeadlineILFactory.DEFAULT_DEADLINE;

  private CallbackProxies() {}

  /**
   * Creates a proxy for the same object that calls on the caller's thread and ends within the
   * deadline. It replaces any JERI proxy, whatever deadline, socket factory or garbage collection
   * that brought. Any other object is returned unchanged; a call on it has no deadline.
   *
   * @param callback the proxy as received
   * @param type the interface to call
   * @param deadline timeout of a call, at least a millisecond
   */
  public static <T extends Remote> T withDeadline(T callback, Class<T> type, Duration deadline) {
    @Nullable BasicInvocationHandler handler = handler(callback);
    if (handler == null) {
      return callback;
    }
    CallbackInvocationHandler bounded =
        new CallbackInvocationHandler(
            withOwnSockets(handler.getObjectEndpoint()), handler.getServerConstraints(), deadline);
    @Nullable MethodConstraints client = handler.getClientConstraints();
    return type.cast(
        Proxy.newProxyInstance(
            type.getClassLoader(),
            new Class<?>[] {type},
            client == null ? bounded : new CallbackInvocationHandler(bounded, client)));
  }

  /**
   * Whether an object may be called back on another computer. {@link #withDeadline} bounds a call
   * by JERI over TCP; a call on a copy in this virtual machine uses no network; and references of
   * plain RMI are read only if they are configured. Over another transport, or by a proxy with its
   * own invocation code, an unanswered call would never end.
   */
  public static boolean isAllowedRemotely(Remote callback) {
    if (!Proxy.isProxyClass(callback.getClass())
        || Proxy.getInvocationHandler(callback) instanceof RemoteObjectInvocationHandler) {
      return true;
    }
    @Nullable BasicInvocationHandler handler = handler(callback);
    return handler != null
        && handler.getObjectEndpoint() instanceof BasicObjectEndpoint basic
        && (basic.getEndpoint() instanceof TransportEndpoint
            || basic.getEndpoint() instanceof TcpEndpoint);
  }

  /**
   * A key for the process of such an object, as far as its proxy shows: its listening address. Two
   * objects in the same process have equal keys.
   */
  public static Object processKey(Remote callback) {
    @Nullable BasicInvocationHandler handler = handler(callback);
    if (handler == null) {
      return callback.getClass();
    }
    @Nullable PeerAddress address = PeerAddress.of(callback);
    return address == null ? handler.getObjectEndpoint().getClass() : address;
  }

  private static @Nullable BasicInvocationHandler handler(Remote callback) {
    if (!Proxy.isProxyClass(callback.getClass())) {
      return null;
    }
    InvocationHandler handler = Proxy.getInvocationHandler(callback);
    return handler instanceof BasicInvocationHandler basic ? basic : null;
  }

  /** Replaces its socket factory, which was sent with it and may block or fail. */
  private static ObjectEndpoint withOwnSockets(ObjectEndpoint endpoint) {
    if (endpoint instanceof BasicObjectEndpoint basic) {
      if (basic.getEndpoint() instanceof TcpEndpoint tcp) {
        return new BasicObjectEndpoint(
            Endpoints.riverClient(tcp.getHost(), tcp.getPort()),
            basic.getObjectIdentifier(),
            false);
      } else if (basic.getEnableDGC()) {
        return new BasicObjectEndpoint(basic.getEndpoint(), basic.getObjectIdentifier(), false);
      }
    }
    return endpoint;
  }
}
