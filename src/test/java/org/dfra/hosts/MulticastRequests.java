package org.dfra.hosts;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListSet;
import net.jini.discovery.Constants;
import net.jini.discovery.IncomingMulticastRequest;

/** Receives multicast requests for lookup services, and records where answers are wanted. */
final class MulticastRequests implements AutoCloseable {

  private static final int LONGEST = 65_536;

  private final MulticastSocket socket;
  private final Set<String> wanted = new ConcurrentSkipListSet<>();

  /**
   * @param address one of this machine's, on whose interface is listened
   */
  MulticastRequests(String address) throws IOException {
    socket = new MulticastSocket(Constants.discoveryPort);
    socket.joinGroup(
        new InetSocketAddress(Constants.getRequestAddress(), Constants.discoveryPort),
        NetworkInterface.getByInetAddress(InetAddress.getByName(address)));
    Thread thread = new Thread(this::run, "multicast requests");
    thread.setDaemon(true);
    thread.start();
  }

  private void run() {
    while (!socket.isClosed()) {
      DatagramPacket packet = new DatagramPacket(new byte[LONGEST], LONGEST);
      try {
        socket.receive(packet);
        wanted.add(new IncomingMulticastRequest(packet).getAddress().getHostAddress());
      } catch (IOException e) {
        if (!socket.isClosed()) {
          wanted.add(e.toString());
        }
      }
    }
  }

  /** Every address so far at which an answer was wanted. */
  Set<String> wanted() {
    return wanted;
  }

  @Override
  public void close() {
    socket.close();
  }
}
