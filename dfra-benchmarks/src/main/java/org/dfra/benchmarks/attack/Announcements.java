package org.dfra.benchmarks.attack;

import com.sun.jini.discovery.Discovery;
import com.sun.jini.discovery.EncodeIterator;
import com.sun.jini.discovery.MulticastAnnouncement;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.MulticastSocket;
import java.util.Random;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.lookup.ServiceID;

/**
 * Announces lookup services by multicast, each with a new identity. The datagrams do not leave this
 * computer. Not thread-safe.
 */
final class Announcements {

  private static final int PACKET = 512;

  private final Random random = new Random(66);
  private final MulticastSocket socket;
  private final String[] groups;

  /**
   * @param groups that each lookup service claims to be a member of
   * @throws IOException if multicast cannot be used
   */
  Announcements(String[] groups) throws IOException {
    this.groups = groups.clone();
    this.socket = new MulticastSocket();
    socket.setTimeToLive(0);
  }

  /**
   * Announces one lookup service.
   *
   * @param host that it claims
   * @param port for unicast discovery
   * @return number of datagrams sent
   * @throws IOException if one cannot be sent
   */
  int send(String host, int port) throws IOException {
    ServiceID id = new ServiceID(random.nextLong(), random.nextLong());
    EncodeIterator packets =
        Discovery.getProtocol1()
            .encodeMulticastAnnouncement(
                new MulticastAnnouncement(0, host, port, groups, id),
                PACKET,
                InvocationConstraints.EMPTY);
    int sent = 0;
    while (packets.hasNext()) {
      for (DatagramPacket each : packets.next()) {
        socket.send(each);
        sent++;
      }
    }
    return sent;
  }
}
