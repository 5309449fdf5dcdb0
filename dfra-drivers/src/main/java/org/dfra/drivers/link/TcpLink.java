package org.dfra.drivers.link;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.channels.SocketChannel;
import java.time.Duration;

/**
 * A TCP connection. It uses a channel's socket, because only that can be interrupted while it
 * connects.
 */
final class TcpLink implements SerialLink {

  private static final Duration CONNECT_TIMEOUT = Duration.ofSeconds(2);

  private final TcpAddress address;
  private final Socket socket;
  private final InputStream in;
  private final OutputStream out;
  private volatile boolean open = true;

  private TcpLink(TcpAddress address, Socket socket) throws IOException {
    this.address = address;
    this.socket = socket;
    this.in = socket.getInputStream();
    this.out = socket.getOutputStream();
  }

  static SerialLink open(TcpAddress address) throws IOException {
    InetSocketAddress target = new InetSocketAddress(address.host(), address.port());
    if (target.isUnresolved()) {
      throw new IOException(address + ": the host name " + address.host() + " is not known");
    }
    SocketChannel channel = SocketChannel.open();
    try {
      Socket socket = channel.socket();
      socket.setTcpNoDelay(true);
      socket.setKeepAlive(true);
      socket.connect(target, (int) CONNECT_TIMEOUT.toMillis());
      return new TcpLink(address, socket);
    } catch (IOException e) {
      channel.close();
      throw new IOException(
          address
              + ": no connection within "
              + CONNECT_TIMEOUT.toSeconds()
              + " s ("
              + e.getMessage()
              + "); is the device's server running, and on this port?",
          e);
    }
  }

  @Override
  public int read(byte[] buffer, int offset, int length, Duration timeout) {
    if (!open) {
      return -1;
    }
    try {
      socket.setSoTimeout((int) Math.max(1, Math.min(Integer.MAX_VALUE, timeout.toMillis())));
      int count = in.read(buffer, offset, length);
      if (count >= 0) {
        return count;
      }
    } catch (SocketTimeoutException e) {
      return open ? 0 : -1;
    } catch (IOException e) {
      // reset by the peer, or closed by us: lost either way
    }
    close();
    return -1;
  }

  @Override
  public void write(byte[] bytes) throws IOException {
    try {
      out.write(bytes);
    } catch (IOException e) {
      close();
      throw new IOException(address + ": the connection is lost (" + e.getMessage() + ")", e);
    }
  }

  @Override
  public boolean isOpen() {
    return open;
  }

  @Override
  public void close() {
    open = false;
    try {
      socket.close();
    } catch (IOException e) {
      // nothing remains to be closed
    }
  }

  @Override
  public String toString() {
    return address.toString();
  }
}
