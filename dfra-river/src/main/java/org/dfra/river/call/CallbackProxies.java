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
import org.jspecify.annotations.Nullable;

/**
 * Objects of other processes that are called back from here, such as listeners. Their proxies were
 * made elsewhere, so nothing about how they call is taken from them but where the object is.
 */
public final class CallbackProxies {

  /** How long the answer of an object that is called back is awaited. */
  public static final Duration DEADLINE = DeadlineILFactory.DEFAULT_DEADLINE;

  private CallbackProxies() {}

  /**
   * A proxy for the same object that calls on the caller's thread and ends within the deadline:
   * that of any JERI proxy, whatever deadline, socket factory or garbage collection it brought. Any
   * other object is returned as it is; a call on it may hold its thread for as long as it likes.
   *
   * @param callback what came from elsewhere
   * @param type what it is called as
   * @param deadline how long an answer is awaited, at least a millisecond
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
   * by JERI over TCP; one on a copy in this virtual machine goes nowhere; and references of plain
   * RMI are read only where they are configured. Over another transport, or by a proxy that has its
   * own way to call, nothing would end a call that is not answered.
   */
  public static boolean isAllowedRemotely(Remote callback) {
    if (!Proxy.isProxyClass(callback.getClass())
        || Proxy.getInvocationHandler(callback) instanceof RemoteObjectInvocationHandler) {
      return true;
    }
    @Nullable BasicInvocationHandler handler = handler(callback);
    return handler != null
        && handler.getObjectEndpoint() instanceof BasicObjectEndpoint basic
        && basic.getEndpoint() instanceof TcpEndpoint;
  }

  /**
   * The process of such an object, as far as its proxy tells: where it listens. Two objects in the
   * same process have equal ones.
   */
  public static Object processKey(Remote callback) {
    @Nullable BasicInvocationHandler handler = handler(callback);
    if (handler == null) {
      return callback.getClass();
    }
    ObjectEndpoint endpoint = withOwnSockets(handler.getObjectEndpoint());
    return endpoint instanceof BasicObjectEndpoint basic
        ? basic.getEndpoint()
        : endpoint.getClass();
  }

  private static @Nullable BasicInvocationHandler handler(Remote callback) {
    if (!Proxy.isProxyClass(callback.getClass())) {
      return null;
    }
    InvocationHandler handler = Proxy.getInvocationHandler(callback);
    return handler instanceof BasicInvocationHandler basic ? basic : null;
  }

  /** Its own socket factory came with it, and may block or fail as it likes. */
  private static ObjectEndpoint withOwnSockets(ObjectEndpoint endpoint) {
    if (endpoint instanceof BasicObjectEndpoint basic
        && basic.getEndpoint() instanceof TcpEndpoint tcp) {
      return new BasicObjectEndpoint(
          Endpoints.tcpClient(tcp.getHost(), tcp.getPort()), basic.getObjectIdentifier(), false);
    }
    return endpoint;
  }
}
