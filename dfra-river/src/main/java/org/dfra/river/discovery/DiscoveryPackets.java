package org.dfra.river.discovery;

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
import java.io.IOException;
import java.net.DatagramPacket;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.lookup.ServiceID;

/**
 * The datagrams of multicast discovery: encodes requests, decodes announcements. River's parsers do
 * the work: the size of the datagram bounds the objects that they create. Of version 2 only the
 * format without keys is supported.
 */
final class DiscoveryPackets {

  /** A name or an address, without characters that could corrupt a log. */
  private static final Pattern HOST = Pattern.compile("[0-9A-Za-z.:%_-]{1,255}");

  private static final Discovery VERSION_1 = Discovery.getProtocol1();
  private static final Discovery VERSION_2 = plaintext();

  private DiscoveryPackets() {}

  private static Discovery plaintext() {
    Client client = new Client();
    return Discovery.getProtocol2(
        new MulticastRequestEncoder[] {client},
        new MulticastRequestDecoder[0],
        new MulticastAnnouncementEncoder[0],
        new MulticastAnnouncementDecoder[] {client},
        new UnicastDiscoveryClient[0],
        new UnicastDiscoveryServer[0]);
  }

  /**
   * Encodes requests to lookup services.
   *
   * @param port TCP port for their responses
   * @param groups whose members are to answer; all if empty
   * @param known lookup services that need not answer
   * @throws IOException if a group's name is too long for a datagram
   */
  static List<DatagramPacket> encodeRequest(
      MulticastSettings settings, int port, List<String> groups, Collection<ServiceID> known)
      throws IOException {
    MulticastRequest request =
        new MulticastRequest(
            settings.host(), port, groups.toArray(String[]::new), known.toArray(ServiceID[]::new));
    EncodeIterator encoded =
        (settings.version() == 1 ? VERSION_1 : VERSION_2)
            .encodeMulticastRequest(request, settings.packetBytes(), InvocationConstraints.EMPTY);
    List<DatagramPacket> packets = new ArrayList<>();
    while (encoded.hasNext()) {
      packets.addAll(List.of(encoded.next()));
    }
    return packets;
  }

  /** Decodes an announcement; empty if the datagram is not one. */
  static Optional<MulticastAnnouncement> decodeAnnouncement(DatagramPacket packet) {
    if (packet.getLength() < Integer.BYTES) {
      return Optional.empty();
    }
    int version = ByteBuffer.wrap(packet.getData(), packet.getOffset(), Integer.BYTES).getInt();
    try {
      MulticastAnnouncement announcement =
          (version == 1 ? VERSION_1 : VERSION_2)
              .decodeMulticastAnnouncement(packet, InvocationConstraints.EMPTY);
      return HOST.matcher(announcement.getHost()).matches() && announcement.getPort() > 0
          ? Optional.of(announcement)
          : Optional.empty();
    } catch (IOException | RuntimeException e) { // the sender is unknown and cannot be notified
      return Optional.empty();
    }
  }
}
