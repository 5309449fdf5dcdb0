package org.dfra.attack.fuzz;

import com.sun.jini.discovery.Discovery;
import com.sun.jini.discovery.EncodeIterator;
import com.sun.jini.discovery.MulticastAnnouncement;
import com.sun.jini.discovery.MulticastAnnouncementDecoder;
import com.sun.jini.discovery.MulticastAnnouncementEncoder;
import com.sun.jini.discovery.MulticastRequest;
import com.sun.jini.discovery.MulticastRequestDecoder;
import com.sun.jini.discovery.MulticastRequestEncoder;
import com.sun.jini.discovery.UnicastDiscoveryClient;
import com.sun.jini.discovery.UnicastDiscoveryServer;
import com.sun.jini.discovery.plaintext.Client;
import com.sun.jini.discovery.plaintext.Server;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.util.List;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.lookup.ServiceID;
import org.dfra.testing.EmbeddedReggie;

/** Datagrams of multicast discovery, written and parsed as River does it, without keys. */
final class DiscoveryDatagrams {

  private static final int PACKET = 512;

  private DiscoveryDatagrams() {}

  private static InvocationConstraints none() {
    return InvocationConstraints.EMPTY;
  }

  /** The two versions of discovery. */
  static List<Discovery> protocols() {
    return List.of(Discovery.getProtocol1(), plaintext());
  }

  /** A client's request from a host. */
  static byte[] request(Discovery protocol, String host) throws IOException {
    MulticastRequest request =
        new MulticastRequest(
            host, 4711, new String[] {"fuzz"}, new ServiceID[] {new ServiceID(1, 2)});
    return first(protocol.encodeMulticastRequest(request, PACKET, none()));
  }

  /** The announcement of a lookup service. */
  static byte[] announcement(Discovery protocol, String host, int port, ServiceID id)
      throws IOException {
    MulticastAnnouncement announced =
        new MulticastAnnouncement(1, host, port, new String[] {"fuzz"}, id);
    return first(protocol.encodeMulticastAnnouncement(announced, PACKET, none()));
  }

  private static byte[] first(EncodeIterator packets) throws IOException {
    DatagramPacket packet = packets.next()[0];
    byte[] bytes = new byte[packet.getLength()];
    System.arraycopy(packet.getData(), packet.getOffset(), bytes, 0, bytes.length);
    return bytes;
  }

  /** Protocol 2 without the formats that need keys. */
  static Discovery plaintext() {
    Client client = new Client();
    Server server = new Server();
    return Discovery.getProtocol2(
        new MulticastRequestEncoder[] {client},
        new MulticastRequestDecoder[] {server},
        new MulticastAnnouncementEncoder[] {server},
        new MulticastAnnouncementDecoder[] {client},
        new UnicastDiscoveryClient[] {client},
        new UnicastDiscoveryServer[] {server});
  }

  /** Whether any of the four parsers takes it. */
  static boolean parses(byte[] bytes) throws IOException {
    boolean taken = false;
    for (Discovery protocol : protocols()) {
      taken |= isRequest(protocol, bytes);
      taken |= isAnnouncement(protocol, bytes);
    }
    return taken;
  }

  private static boolean isRequest(Discovery protocol, byte[] bytes) throws IOException {
    try {
      return protocol.decodeMulticastRequest(packet(bytes), none(), null).getGroups() != null;
    } catch (IOException | RuntimeException e) { // refused: the listener's thread catches both
      return false;
    }
  }

  private static boolean isAnnouncement(Discovery protocol, byte[] bytes) throws IOException {
    try {
      return protocol.decodeMulticastAnnouncement(packet(bytes), none()).getGroups() != null;
    } catch (IOException | RuntimeException e) { // refused: the listener's thread catches both
      return false;
    }
  }

  /** As it is received: in a buffer for the longest. */
  static DatagramPacket packet(byte[] bytes) throws IOException {
    byte[] buffer = new byte[Math.max(PACKET, bytes.length)];
    System.arraycopy(bytes, 0, buffer, 0, bytes.length);
    return new DatagramPacket(
        buffer, 0, bytes.length, InetAddress.getByName(EmbeddedReggie.HOST), 4711);
  }
}
