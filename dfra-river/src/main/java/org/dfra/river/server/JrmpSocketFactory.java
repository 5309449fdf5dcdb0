package org.dfra.river.server;

import java.io.IOException;
import java.io.Serializable;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.rmi.server.RMIClientSocketFactory;
import java.rmi.server.RMIServerSocketFactory;

/**
 * Sockets of a JRMP export. The server listens on one address only. Clients connect to that
 * address, whatever name the server has for itself. They abort a call when no data arrive within
 * the deadline.
 *
 * @param host address or name that clients connect to
 * @param deadlineMillis the longest wait for an answer, in milliseconds, at least 1
 */
record JrmpSocketFactory(String host, int deadlineMillis)
    implements RMIClientSocketFactory, RMIServerSocketFactory, Serializable {

  JrmpSocketFactory {
    if (deadlineMillis < 1) {
      throw new IllegalArgumentException("deadline " + deadlineMillis + " ms is shorter than 1 ms");
    }
  }

  @Override
  public Socket createSocket(String ignored, int port) throws IOException {
    Socket socket = new Socket();
    socket.connect(new InetSocketAddress(host, port), deadlineMillis);
    socket.setSoTimeout(deadlineMillis);
    return socket;
  }

  @Override
  public ServerSocket createServerSocket(int port) throws IOException {
    return new ServerSocket(port, 0, InetAddress.getByName(host));
  }
}
