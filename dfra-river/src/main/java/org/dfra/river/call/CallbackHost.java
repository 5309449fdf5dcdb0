package org.dfra.river.call;

import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.channels.DatagramChannel;
import java.rmi.Remote;
import net.jini.jeri.BasicInvocationHandler;
import net.jini.jeri.BasicObjectEndpoint;
import net.jini.jeri.Endpoint;
import net.jini.jeri.tcp.TcpEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * The address of this machine at which a server can call a client back: that of the system property
 * {@value #PROPERTY}, or else the one from which this machine reaches the server.
 */
public final class CallbackHost {

  /** System property with an address or name of this machine. */
  public static final String PROPERTY = "dfra.host";

  /** Any port will do: nothing is sent. */
  private static final int PORT = 9;

  private CallbackHost() {}

  /**
   * The address for callbacks from a server.
   *
   * @param server its remote proxy
   * @throws IOException if this machine has no route to the server
   */
  public static String addressReachableFrom(Remote server) throws IOException {
    String configured = System.getProperty(PROPERTY);
    if (configured != null) {
      return configured;
    }
    String host = hostOf(server);
    if (host == null) {
      return InetAddress.getLocalHost().getHostAddress();
    }
    try (DatagramChannel channel = DatagramChannel.open()) {
      channel.connect(new InetSocketAddress(InetAddress.getByName(host), PORT));
      return ((InetSocketAddress) channel.getLocalAddress()).getAddress().getHostAddress();
    }
  }

  private static @Nullable String hostOf(@Nullable Remote server) {
    if (server == null || !Proxy.isProxyClass(server.getClass())) {
      return null;
    }
    InvocationHandler handler = Proxy.getInvocationHandler(server);
    if (handler instanceof ResurrectingHandler resurrecting) {
      return hostOf(resurrecting.live());
    }
    if (handler instanceof BasicInvocationHandler basic
        && basic.getObjectEndpoint() instanceof BasicObjectEndpoint object) {
      Endpoint endpoint = object.getEndpoint();
      return endpoint instanceof TcpEndpoint tcp ? tcp.getHost() : null;
    }
    return null;
  }
}
