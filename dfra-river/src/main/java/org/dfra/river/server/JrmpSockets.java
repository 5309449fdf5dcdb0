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
 * Sockets of a JRMP export: the server listens on one address only, clients connect to that one
 * whatever the server takes its name to be, and give an answer up when nothing of it has come
 * within the deadline.
 *
 * @param host address or name that clients connect to
 * @param deadlineMillis how long an answer is awaited, in milliseconds, at least 1
 */
record JrmpSockets(String host, int deadlineMillis)
    implements RMIClientSocketFactory, RMIServerSocketFactory, Serializable {

  JrmpSockets {
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
