package org.dfra.river.transport;

import java.nio.ByteBuffer;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLEngineResult;
import javax.net.ssl.SSLEngineResult.HandshakeStatus;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSession;

/**
 * The JDK's engine for one connection. Whatever a peer makes it throw is an {@link SSLException}
 * here, and so ends that connection only.
 */
final class TlsEngine {

  private final SSLEngine engine;

  TlsEngine(SSLEngine engine) {
    this.engine = engine;
  }

  /** What the handshake needs next. */
  HandshakeStatus status() {
    return engine.getHandshakeStatus();
  }

  /** Its session, once the handshake is over. */
  SSLSession session() {
    return engine.getSession();
  }

  void begin() throws SSLException {
    try {
      engine.beginHandshake();
    } catch (RuntimeException e) {
      throw failed(e);
    }
  }

  /** Computes what the handshake waits for. */
  void runTasks() throws SSLException {
    try {
      for (Runnable task = engine.getDelegatedTask();
          task != null;
          task = engine.getDelegatedTask()) {
        task.run();
      }
    } catch (RuntimeException e) {
      throw failed(e);
    }
  }

  SSLEngineResult unwrap(ByteBuffer from, ByteBuffer to) throws SSLException {
    try {
      return engine.unwrap(from, to);
    } catch (RuntimeException e) {
      throw failed(e);
    }
  }

  SSLEngineResult wrap(ByteBuffer from, ByteBuffer to) throws SSLException {
    try {
      return engine.wrap(from, to);
    } catch (RuntimeException e) {
      throw failed(e);
    }
  }

  private static SSLException failed(RuntimeException e) {
    return new SSLException("TLS failed: " + e, e);
  }
}
