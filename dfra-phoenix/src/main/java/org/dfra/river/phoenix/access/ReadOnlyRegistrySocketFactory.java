package org.dfra.river.phoenix.access;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.UnknownHostException;
import java.rmi.server.RMIServerSocketFactory;

/**
 * Sockets that make an RMI registry read-only. They listen on the loopback interface only and
 * present every caller as one from another host. A registry refuses bind, rebind and unbind to such
 * a caller. The caller itself receives its true address in the acknowledgement, see {@link
 * AddressRewritingStream}.
 *
 * <p>Without them, any program on a registry's host can unbind a name: the registry's filter does
 * not see that call, which sends only a string.
 */
public final class ReadOnlyRegistrySocketFactory implements RMIServerSocketFactory {

  /** An address of a network for documentation only (RFC 5737), so no host has it. */
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

  /** A connection that reports a remote peer, but sends the peer its true address. */
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
