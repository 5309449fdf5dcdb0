package org.dfra.core.audit;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.time.temporal.ChronoUnit;
import java.util.Locale;
import java.util.Optional;
import org.dfra.core.audit.AuditLine.Header;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Member;
import org.dfra.text.PrintableText;

/** Writes records as lines of JSON, always in the same order of fields. */
final class LineEncoder {

  private static final JsonFactory FACTORY = new JsonFactory();
  private static final int LONGEST_ADDRESS = 100;

  /** ISO 8601 with milliseconds, so that columns are aligned. */
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss.SSS'Z'", Locale.ROOT)
          .withZone(ZoneOffset.UTC);

  private LineEncoder() {}

  static String time(Instant time) {
    return TIME.format(time.truncatedTo(ChronoUnit.MILLIS));
  }

  /** The line of a record after a position, without its end. */
  static byte[] encode(AuditEntry entry, TrailPosition before) {
    return encode(entry, Optional.empty(), before);
  }

  /** The first line of a file. */
  static byte[] encode(Header header, Instant time, TrailPosition before) {
    AuditEvent opened = AuditEvent.ofProcess(AuditKind.FILE_OPENED, "", "");
    return encode(AuditEntry.single(opened, time), Optional.of(header), before);
  }

  private static byte[] encode(AuditEntry entry, Optional<Header> header, TrailPosition before) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream(512);
    try (JsonGenerator json = FACTORY.createGenerator(bytes)) {
      json.writeStartObject();
      json.writeNumberField("n", before.number() + 1);
      json.writeStringField("time", time(entry.time()));
      json.writeStringField("kind", entry.event().kind().text());
      if (header.isPresent()) {
        json.writeNumberField("format", LineDecoder.FORMAT);
        json.writeStringField("stream", header.get().stream());
        json.writeNumberField("file", header.get().file());
        json.writeNumberField("files", header.get().files());
        json.writeStringField("owner", header.get().owner());
      }
      writeEvent(entry.event(), json);
      if (entry.count() != 1 || entry.since().isPresent()) {
        json.writeNumberField("count", entry.count());
      }
      if (entry.since().isPresent()) {
        json.writeStringField("since", time(entry.since().get()));
      }
      json.writeStringField("prev", before.hash());
      json.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException("cannot happen in memory", e);
    }
    return bytes.toByteArray();
  }

  private static void writeEvent(AuditEvent event, JsonGenerator json) throws IOException {
    if (event.caller().isPresent()) {
      Caller caller = event.caller().get();
      json.writeStringField("standing", caller.standing().name().toLowerCase(Locale.ROOT));
      writeText("member", caller.member().map(Member::toString).orElse(""), json);
      writeText("for", caller.behalf().map(Behalf::toString).orElse(""), json);
      writeText("address", PrintableText.line(caller.address(), LONGEST_ADDRESS), json);
    }
    writeText("robot", event.robot(), json);
    writeText("object", event.object(), json);
    writeText("method", event.method(), json);
    boolean isStart = event.kind() == AuditKind.PROCESS_STARTED;
    writeText(isStart ? "mode" : "decision", event.decision(), json);
    writeText("rule", event.rule(), json);
    writeText("reason", event.reason(), json);
    if (!event.obligations().isEmpty()) {
      json.writeArrayFieldStart("obligations");
      for (String each : event.obligations()) {
        json.writeString(each);
      }
      json.writeEndArray();
    }
  }

  private static void writeText(String name, String text, JsonGenerator json) throws IOException {
    if (!text.isEmpty()) {
      json.writeStringField(name, text);
    }
  }
}
