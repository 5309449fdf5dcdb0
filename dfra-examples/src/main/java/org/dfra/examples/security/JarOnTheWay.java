package org.dfra.examples.security;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.dfra.examples.harness.DemoEnvironment;

/**
 * A jar that a robot serves, and the same jar as somebody on the way delivers it: with one bit
 * changed.
 */
final class JarOnTheWay implements AutoCloseable {

  private static final String AS_SERVED = "/panel-dl.jar";
  private static final String ALTERED = "/altered-panel-dl.jar";

  private final byte[] jar;
  private final HttpServer server;

  /** Serves both at a free port. */
  JarOnTheWay() throws IOException {
    jar = jar();
    server =
        HttpServer.create(
            new InetSocketAddress(InetAddress.getByName(DemoEnvironment.ADDRESS), 0), 0);
    server.createContext(AS_SERVED, exchange -> send(exchange, jar));
    server.createContext(ALTERED, exchange -> send(exchange, altered()));
    server.start();
  }

  private static byte[] jar() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (JarOutputStream out = new JarOutputStream(bytes)) {
      out.putNextEntry(new JarEntry("field/panel.properties"));
      out.write("title = A panel of the field\n".getBytes(StandardCharsets.ISO_8859_1));
      out.closeEntry();
    }
    return bytes.toByteArray();
  }

  private byte[] altered() {
    byte[] changed = jar.clone();
    changed[changed.length / 2] ^= 1;
    return changed;
  }

  private static void send(HttpExchange exchange, byte[] body) throws IOException {
    try (exchange) {
      exchange.sendResponseHeaders(200, body.length);
      try (OutputStream out = exchange.getResponseBody()) {
        out.write(body);
      }
    }
  }

  /** The codebase of the jar as the robot serves it. */
  String codebase() {
    return codebase(AS_SERVED);
  }

  /** The codebase with the same digest, whose jar was changed on the way. */
  String alteredCodebase() {
    return codebase(ALTERED);
  }

  private String codebase(String path) {
    return "httpmd://"
        + DemoEnvironment.ADDRESS
        + ":"
        + server.getAddress().getPort()
        + path
        + ";sha-256="
        + digest();
  }

  /** The SHA-256 of the jar in hexadecimal digits. */
  String digest() {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(jar));
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("every JDK has SHA-256", e);
    }
  }

  @Override
  public void close() {
    server.stop(0);
  }
}
