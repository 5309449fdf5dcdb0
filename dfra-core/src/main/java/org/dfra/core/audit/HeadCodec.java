package org.dfra.core.audit;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayInputStream;
import java.io.IOException;
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

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private HeadCodec() {}

  static String line(KeptHead kept) {
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
      return MAPPER.writeValueAsString(json);
    } catch (CertificateException | JsonProcessingException e) {
      throw new IllegalStateException("a certificate that was read cannot be written", e);
    }
  }

  /** Reads a file of heads; at most {@link HeadStore#MOST_HEADS}. */
  static List<KeptHead> read(Path file) throws IOException {
    List<KeptHead> heads = new ArrayList<>();
    try (LineReader lines = LineReader.open(file, 0)) {
      int number = 0;
      for (@Nullable RawLine line = lines.next(); line != null; line = lines.next()) {
        number++;
        try {
          heads.add(parse(line.bytes()));
        } catch (IOException | IllegalArgumentException | DateTimeException e) {
          throw new IOException(
              file + ":" + number + ": this is no head of an audit trail: " + e.getMessage(), e);
        }
        if (heads.size() > HeadStore.MOST_HEADS) {
          throw new IOException(file + " has more than " + HeadStore.MOST_HEADS + " heads");
        }
      }
    } catch (NoSuchFileException e) {
      throw new IOException("there is no file " + file + " with heads of audit trails", e);
    }
    return heads;
  }

  private static KeptHead parse(byte[] line) throws IOException {
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
    return KeptHead.of(head, certificate(json.path("certificate").asText()));
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
