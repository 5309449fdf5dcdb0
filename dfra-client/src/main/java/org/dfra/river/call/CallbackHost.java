package org.dfra.river.call;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.channels.DatagramChannel;
import java.rmi.Remote;
import org.jspecify.annotations.Nullable;

/**
 * The address of this machine at which a server can call a client back: that of the system property
 * {@value #PROPERTY}, or else the one from which this machine reaches the server.
 */
public final class CallbackHost {

  /** System property with an address or name of this machine. */
  public static final String PROPERTY = "dfra.callback-host";

  /**
   * Its former name, valid until the next release. Not in the table of renamed names, which a
   * client that downloads this class does not have.
   */
  private static final String OLD_PROPERTY = "dfra.host";

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
    String configured = System.getProperty(PROPERTY, System.getProperty(OLD_PROPERTY));
    if (configured != null) {
      return configured;
    }
    @Nullable PeerAddress peer = PeerAddress.of(server);
    if (peer == null) {
      return InetAddress.getLocalHost().getHostAddress();
    }
    try (DatagramChannel channel = DatagramChannel.open()) {
      channel.connect(new InetSocketAddress(InetAddress.getByName(peer.host()), PORT));
      return ((InetSocketAddress) channel.getLocalAddress()).getAddress().getHostAddress();
    }
  }
}
