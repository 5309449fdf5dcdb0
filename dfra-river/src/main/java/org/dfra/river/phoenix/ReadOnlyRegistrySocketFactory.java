package org.dfra.river.phoenix;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.UnknownHostException;
import java.rmi.server.RMIServerSocketFactory;

/**
 * Sockets that make an RMI registry read-only: it listens on the loopback interface alone, and
 * takes every caller for one from another host, to whom a registry refuses bind, rebind and unbind.
 * The caller itself gets its true address in the acknowledgement, see {@link
 * AddressRewritingStream}.
 *
 * <p>A registry lets any program on its host unbind a name, and its filter does not see that call,
 * which sends nothing but a string.
 */
final class ReadOnlyRegistrySocketFactory implements RMIServerSocketFactory {

  /** Of a network that is for documentation only (RFC 5737), so no host has it. */
  static final InetAddress DOCUMENTATION_ADDRESS = elsewhere();

  @Override
  public ServerSocket createServerSocket(int port) throws IOException {
    return new ServerSocket(port, 0, InetAddress.getLoopbackAddress()) {
      @Override
      public Socket accept() throws IOException {
        Socket socket = new CallerSocket();
        implAccept(socket);
        return socket;
      }
    };
  }

  /** A connection whose other end seems to be elsewhere, but is sent its true address. */
  private static final class CallerSocket extends Socket {

    @Override
    public InetAddress getInetAddress() {
      return DOCUMENTATION_ADDRESS;
    }

    @Override
    public OutputStream getOutputStream() throws IOException {
      return new AddressRewritingStream(
          super.getOutputStream(),
          DOCUMENTATION_ADDRESS.getHostAddress(),
          super.getInetAddress().getHostAddress());
    }
  }

  private static InetAddress elsewhere() {
    try {
      return InetAddress.getByAddress(new byte[] {(byte) 203, 0, 113, 1});
    } catch (UnknownHostException e) {
      throw new IllegalStateException("four bytes are an address", e);
    }
  }
}
