package org.dfra.river.call;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.rmi.Remote;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.tcp.TcpEndpoint;
import org.dfra.river.transport.AbortableEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * The address at which a remote proxy calls its server. The proxy's sender chose it.
 *
 * @param host as the proxy names it: an address in digits, or a name that was not looked up
 * @param port TCP port
 */
public record PeerAddress(String host, int port) {

  /**
   * Reads the address from a proxy without a remote call.
   *
   * @return null if it is no JERI proxy over TCP
   */
  public static @Nullable PeerAddress of(@Nullable Remote proxy) {
    if (proxy == null || !Proxy.isProxyClass(proxy.getClass())) {
      return null;
    }
    InvocationHandler handler = Proxy.getInvocationHandler(proxy);
    if (handler instanceof ResurrectingHandler resurrecting) {
      return of(resurrecting.live());
    }
    return handler instanceof BasicInvocationHandler basic
            && basic.getObjectEndpoint() instanceof BasicObjectEndpoint object
        ? ofEndpoint(object.getEndpoint())
        : null;
  }

  /** The address of a server; null if its endpoint shows none. */
  static @Nullable PeerAddress ofEndpoint(Object endpoint) {
    if (endpoint instanceof AbortableEndpoint own) {
      return new PeerAddress(own.host(), own.port());
    }
    return endpoint instanceof TcpEndpoint tcp
        ? new PeerAddress(tcp.getHost(), tcp.getPort())
        : null;
  }
}
