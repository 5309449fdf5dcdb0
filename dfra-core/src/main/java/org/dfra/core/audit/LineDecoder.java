package org.dfra.core.audit;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.dfra.core.audit.AuditLine.Header;
import org.dfra.text.PrintableText;

/** Reads lines of the audit trail. Fields of later versions are ignored. */
final class LineDecoder {

  /** The version of the form; a file of a later one is refused. */
  static final int FORMAT = 1;

  private static final ObjectMapper MAPPER =
      JsonMapper.builder()
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .build();

  private static final Pattern HASH = Pattern.compile("[0-9a-f]{64}");

  private LineDecoder() {}

  /**
   * Reads a line.
   *
   * @param line without its end
   * @throws IOException if it is no line of a trail; the message says what is wrong
   */
  static AuditLine decode(byte[] line) throws IOException {
    JsonNode json = tree(line);
    try {
      return new AuditLine(
          positive(json, "n"),
          Instant.parse(text(json, "time")),
          required(json, "kind"),
          text(json, "standing"),
          text(json, "member"),
          text(json, "for"),
          text(json, "address"),
          text(json, "robot"),
          text(json, "object"),
          text(json, "method"),
          json.has("mode") ? text(json, "mode") : text(json, "decision"),
          text(json, "rule"),
          text(json, "reason"),
          texts(json.path("obligations")),
          json.has("count") ? positive(json, "count") : 1,
          json.has("since") ? Optional.of(Instant.parse(text(json, "since"))) : Optional.empty(),
          header(json),
          hash(json));
    } catch (DateTimeException e) {
      throw new IOException("its time is not in ISO 8601", e);
    }
  }

  private static JsonNode tree(byte[] line) throws IOException {
    try {
      JsonNode json = MAPPER.readTree(line);
      if (json != null && json.isObject()) {
        return json;
      }
    } catch (JsonProcessingException e) {
      throw new IOException(
          "it is not JSON: " + PrintableText.line(e.getOriginalMessage(), 100), e);
    }
    throw new IOException("it is not a JSON object");
  }

  private static Optional<Header> header(JsonNode json) throws IOException {
    if (!text(json, "kind").equals(AuditKind.FILE_OPENED.text())) {
      return Optional.empty();
    }
    if (positive(json, "format") > FORMAT) {
      throw new IOException(
          "it is of format "
              + positive(json, "format")
              + " > "
              + FORMAT
              + "; use a newer version of DFRA");
    }
    int files = (int) Math.min(Integer.MAX_VALUE, positive(json, "files"));
    return Optional.of(
        new Header(required(json, "stream"), positive(json, "file"), files, text(json, "owner")));
  }

  private static long positive(JsonNode json, String field) throws IOException {
    JsonNode value = json.path(field);
    if (!value.canConvertToLong() || !value.isIntegralNumber() || value.longValue() < 1) {
      throw new IOException("its \"" + field + "\" is not a positive whole number");
    }
    return value.longValue();
  }

  private static String hash(JsonNode json) throws IOException {
    String hash = text(json, "prev");
    if (!HASH.matcher(hash).matches()) {
      throw new IOException("its \"prev\" is not 64 hexadecimal digits");
    }
    return hash;
  }

  private static String required(JsonNode json, String field) throws IOException {
    String text = text(json, field);
    if (text.isEmpty()) {
      throw new IOException("it has no \"" + field + "\"");
    }
    return text;
  }

  private static String text(JsonNode json, String field) throws IOException {
    JsonNode value = json.path(field);
    if (!value.isMissingNode() && !value.isTextual()) {
      throw new IOException("its \"" + field + "\" is not a text");
    }
    return value.asText("");
  }

  private static List<String> texts(JsonNode array) {
    List<String> texts = new ArrayList<>();
    array.forEach(each -> texts.add(each.asText()));
    return texts;
  }
}
