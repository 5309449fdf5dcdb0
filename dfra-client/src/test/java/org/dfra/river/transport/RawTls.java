package org.dfra.river.transport;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLEngineResult;
import javax.net.ssl.SSLEngineResult.HandshakeStatus;
import javax.net.ssl.SSLException;
import org.dfra.river.identity.ChannelIdentity;

/** A client that decides for itself which bytes of TLS it sends, and when. */
final class RawTls implements AutoCloseable {

  /** The memory that each needs beside TLS, in bytes. */
  static final int BUFFER = 64 * 1024;

  private final Socket socket = new Socket();
  private final SSLEngine engine;
  private final ByteBuffer received = ByteBuffer.allocate(BUFFER); // ready to be appended to

  private RawTls(String source, int port, SSLEngine engine) throws IOException {
    this.engine = engine;
    socket.bind(new InetSocketAddress(InetAddress.getByName(source), 0));
    socket.connect(new InetSocketAddress(RecordingServer.HOST, port));
    socket.setSoTimeout(30_000);
    socket.setTcpNoDelay(true);
    socket.setSoLinger(true, 0); // leaves no port behind
  }

  /** Connects and agrees on TLS; the handshake is next. */
  static RawTls greeted(String source, int port, ChannelIdentity identity) throws IOException {
    RawTls client = new RawTls(source, port, identity.clientEngine(source, port));
    ByteBuffer greeting = ByteBuffer.allocate(Greeting.CLIENT_BYTES);
    Greeting.putClient(greeting, Greeting.ANY_SERVER, true, false);
    client.send(greeting.array());
    byte[] answer = client.in().readNBytes(Greeting.SERVER_BYTES);
    if (answer.length < Greeting.SERVER_BYTES
        || Greeting.readServer(ByteBuffer.wrap(answer)) != Greeting.Answer.WELCOME) {
      client.close();
      throw new IOException("the server does not welcome a client");
    }
    return client;
  }

  /** One whose handshake is complete. */
  static RawTls connected(String source, int port, ChannelIdentity identity) throws IOException {
    RawTls client = greeted(source, port, identity);
    client.handshake(false);
    return client;
  }

  /** One whose handshake is complete, and that has sent half a record with the end of it. */
  static RawTls connectedWithHalfARecord(String source, int port, ChannelIdentity identity)
      throws IOException {
    RawTls client = greeted(source, port, identity);
    client.handshake(true);
    return client;
  }

  private InputStream in() throws IOException {
    return socket.getInputStream();
  }

  Socket socket() {
    return socket;
  }

  void send(byte[] bytes) throws IOException {
    socket.getOutputStream().write(bytes);
  }

  /** The records with which the handshake begins. */
  byte[] hello() throws SSLException {
    engine.beginHandshake();
    return wrapAll(new byte[0]);
  }

  private void handshake(boolean sendsHalfARecord) throws IOException {
    send(hello());
    while (engine.getHandshakeStatus() != HandshakeStatus.NOT_HANDSHAKING) {
      switch (engine.getHandshakeStatus()) {
        case NEED_TASK -> engine.getDelegatedTask().run();
        case NEED_WRAP -> {
          ByteArrayOutputStream flight = new ByteArrayOutputStream();
          flight.writeBytes(wrapAll(new byte[0]));
          if (sendsHalfARecord && engine.getHandshakeStatus() == HandshakeStatus.NOT_HANDSHAKING) {
            flight.write(block(Block.Kind.END, new byte[100]), 0, 60);
          }
          send(flight.toByteArray());
        }
        default -> {
          byte[] unused = unwrap();
        }
      }
    }
  }

  /** Records with data, or those that the handshake needs next. */
  private byte[] wrapAll(byte[] data) throws SSLException {
    ByteArrayOutputStream records = new ByteArrayOutputStream();
    ByteBuffer from = ByteBuffer.wrap(data);
    do {
      ByteBuffer to = ByteBuffer.allocate(BUFFER);
      SSLEngineResult unused = engine.wrap(from, to);
      records.write(to.array(), 0, to.position());
    } while (from.hasRemaining() || engine.getHandshakeStatus() == HandshakeStatus.NEED_WRAP);
    return records.toByteArray();
  }

  /** Data in records. */
  byte[] record(byte[] data) throws SSLException {
    return wrapAll(data);
  }

  /** A block of the transport, in records. */
  byte[] block(Block.Kind kind, byte[] data) throws SSLException {
    return record(
        ByteBuffer.allocate(Block.HEADER_BYTES + data.length)
            .putInt(Block.encode(kind, data.length))
            .put(data)
            .array());
  }

  /** A request for new keys. */
  byte[] keyUpdate() throws SSLException {
    engine.beginHandshake();
    return wrapAll(new byte[0]);
  }

  /** Receives a record. Returns its data. */
  private byte[] unwrap() throws IOException {
    while (true) {
      ByteBuffer to = ByteBuffer.allocate(BUFFER);
      received.flip();
      SSLEngineResult result = engine.unwrap(received, to);
      received.compact();
      switch (result.getStatus()) {
        case OK -> {
          return java.util.Arrays.copyOf(to.array(), to.position());
        }
        case BUFFER_UNDERFLOW -> {
          int count = in().read(received.array(), received.position(), received.remaining());
          if (count < 0) {
            throw new EOFException("the server has closed the connection");
          }
          received.position(received.position() + count);
        }
        default -> throw new EOFException("the server has ended TLS: " + result.getStatus());
      }
    }
  }

  /** Receives so many bytes of data. */
  byte[] readData(int count) throws IOException {
    ByteArrayOutputStream data = new ByteArrayOutputStream();
    while (data.size() < count) {
      data.writeBytes(unwrap());
    }
    return data.toByteArray();
  }

  /** Receives bytes as they are, to the end. */
  byte[] readRawToEnd() throws IOException {
    try {
      return in().readAllBytes();
    } catch (java.net.SocketException e) { // reset
      return new byte[0];
    }
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
