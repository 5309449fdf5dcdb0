package org.dfra.river.call;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.rmi.Remote;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.tcp.TcpEndpoint;
import org.dfra.river.transport.TransportEndpoint;
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
    if (!(handler instanceof BasicInvocationHandler basic)
        || !(basic.getObjectEndpoint() instanceof BasicObjectEndpoint object)) {
      return null;
    }
    if (object.getEndpoint() instanceof TransportEndpoint endpoint) {
      return new PeerAddress(endpoint.host(), endpoint.port());
    }
    return object.getEndpoint() instanceof TcpEndpoint tcp
        ? new PeerAddress(tcp.getHost(), tcp.getPort())
        : null;
  }
}
