package org.dfra.cli.doctor;

import com.sun.jini.discovery.Discovery;
import com.sun.jini.discovery.EncodeIterator;
import com.sun.jini.discovery.MulticastRequest;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.lookup.ServiceID;
import net.jini.discovery.Constants;

/**
 * Multicast as lookup services and their clients use it: 224.0.1.85 for requests, 224.0.1.84 for
 * announcements, UDP port 4160. The request is for a group that does not exist, so no lookup
 * service answers.
 */
final class JiniMulticast implements MulticastCheck.Network {

  private static final int LARGEST = 512;

  @Override
  public List<String> interfaces() throws IOException {
    List<String> names = new ArrayList<>();
    for (NetworkInterface each : NetworkInterface.networkInterfaces().toList()) {
      boolean hasAddress = each.inetAddresses().anyMatch(a -> a.getAddress().length == 4);
      if (each.isUp() && !each.isLoopback() && each.supportsMulticast() && hasAddress) {
        names.add(each.getName());
      }
    }
    return names;
  }

  @Override
  public Optional<Duration> roundTrip(String networkInterface) throws IOException {
    NetworkInterface there = NetworkInterface.getByName(networkInterface);
    InetAddress requests = Constants.getRequestAddress();
    InetAddress announcements = Constants.getAnnouncementAddress();
    try (MulticastSocket ear = new MulticastSocket(Constants.discoveryPort);
        MulticastSocket mouth = new MulticastSocket()) {
      ear.joinGroup(new InetSocketAddress(requests, Constants.discoveryPort), there);
      ear.joinGroup(new InetSocketAddress(announcements, Constants.discoveryPort), there);
      mouth.setNetworkInterface(there);
      mouth.setTimeToLive(1); // to the next router
      byte[] sent = request();
      long began = System.nanoTime();
      mouth.send(
          new DatagramPacket(
              sent, sent.length, new InetSocketAddress(requests, Constants.discoveryPort)));
      return receives(ear, sent, began);
    }
  }

  private static Optional<Duration> receives(MulticastSocket ear, byte[] sent, long began)
      throws IOException {
    long end = began + MulticastCheck.PATIENCE.toNanos();
    DatagramPacket received = new DatagramPacket(new byte[LARGEST], LARGEST);
    for (long now = began; now - end < 0; now = System.nanoTime()) {
      ear.setSoTimeout((int) Math.max(1, (end - now) / 1_000_000));
      try {
        ear.receive(received);
      } catch (SocketTimeoutException e) {
        return Optional.empty();
      }
      byte[] bytes = Arrays.copyOf(received.getData(), received.getLength());
      if (Arrays.equals(bytes, sent)) { // others talk too
        return Optional.of(Duration.ofNanos(System.nanoTime() - began));
      }
    }
    return Optional.empty();
  }

  private static byte[] request() throws IOException {
    MulticastRequest nobody =
        new MulticastRequest(
            InetAddress.getLoopbackAddress().getHostAddress(),
            1,
            new String[] {"dfra-doctor-" + UUID.randomUUID()},
            new ServiceID[0]);
    EncodeIterator packets =
        Discovery.getProtocol2(JiniMulticast.class.getClassLoader())
            .encodeMulticastRequest(nobody, LARGEST, InvocationConstraints.EMPTY);
    DatagramPacket packet = packets.next()[0];
    return Arrays.copyOfRange(
        packet.getData(), packet.getOffset(), packet.getOffset() + packet.getLength());
  }
}
