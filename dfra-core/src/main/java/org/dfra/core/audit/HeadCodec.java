package org.dfra.core.audit;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import org.dfra.core.audit.LineReader.RawLine;
import org.jspecify.annotations.Nullable;

/** Heads as lines of JSON. */
final class HeadCodec {

  /** One more than a stream's heads, for one that contradicts. */
  private static final int MOST_LINES = HeadStore.MOST_HEADS * (HeadStore.MOST_OF_STREAM + 1);

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private HeadCodec() {}

  static String line(ReceivedHead received) {
    KeptHead kept = received.kept();
    ObjectNode json = MAPPER.createObjectNode();
    json.put("member", kept.member().toString());
    json.put("stream", kept.head().stream());
    json.put("n", kept.head().number());
    json.put("hash", kept.head().hash());
    json.put("time", LineEncoder.time(kept.head().time()));
    json.put("signature", kept.head().signature());
    try {
      byte[] certificate = kept.certificate().getEncoded();
      json.put("certificate", Base64.getEncoder().encodeToString(certificate));
      json.put("received", LineEncoder.time(received.received()));
      return MAPPER.writeValueAsString(json);
    } catch (CertificateException | JsonProcessingException e) {
      throw new IllegalStateException("a certificate that was read cannot be written", e);
    }
  }

  /** Reads a file of heads; at most {@value #MOST_LINES}. */
  static List<ReceivedHead> read(Path file) throws IOException {
    try (LineReader lines = LineReader.open(file, 0)) {
      return read(lines, file.toString());
    } catch (NoSuchFileException e) {
      throw new IOException("there is no file " + file + " with heads of audit trails", e);
    }
  }

  /** Reads heads; at most {@value #MOST_LINES}. */
  static List<ReceivedHead> read(InputStream in, String name) throws IOException {
    try (LineReader lines = new LineReader(in, 0)) {
      return read(lines, name);
    }
  }

  private static List<ReceivedHead> read(LineReader lines, String name) throws IOException {
    List<ReceivedHead> heads = new ArrayList<>();
    int number = 0;
    for (@Nullable RawLine line = lines.next(); line != null; line = lines.next()) {
      number++;
      try {
        heads.add(parse(line.bytes()));
      } catch (IOException | IllegalArgumentException | DateTimeException e) {
        throw new IOException(
            name + ":" + number + ": this is no head of an audit trail: " + e.getMessage(), e);
      }
      if (heads.size() > MOST_LINES) {
        throw new IOException(name + " has more than " + MOST_LINES + " heads");
      }
    }
    return heads;
  }

  private static ReceivedHead parse(byte[] line) throws IOException {
    JsonNode json = MAPPER.readTree(line);
    if (json == null || !json.isObject()) {
      throw new IOException("it is not a JSON object");
    }
    AuditHead head =
        new AuditHead(
            json.path("stream").asText(),
            json.path("n").asLong(),
            json.path("hash").asText(),
            Instant.parse(json.path("time").asText()),
            json.path("signature").asText());
    KeptHead kept = KeptHead.of(head, certificate(json.path("certificate").asText()));
    JsonNode received = json.path("received"); // missing in files of former versions
    return new ReceivedHead(
        kept, received.isMissingNode() ? head.time() : Instant.parse(received.asText()));
  }

  private static X509Certificate certificate(String text) throws IOException {
    try {
      byte[] bytes = Base64.getDecoder().decode(text);
      return (X509Certificate)
          CertificateFactory.getInstance("X.509")
              .generateCertificate(new ByteArrayInputStream(bytes));
    } catch (CertificateException e) {
      throw new IOException("its certificate cannot be read", e);
    }
  }
}
