package org.dfra.report.terminal;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationContext;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.deser.std.StdDeserializer;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.module.SimpleModule;
import com.fasterxml.jackson.databind.ser.std.StdSerializer;
import com.fasterxml.jackson.databind.ser.std.ToStringSerializer;
import com.fasterxml.jackson.datatype.jdk8.Jdk8Module;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Type;
import java.time.Duration;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.time.temporal.Temporal;
import org.dfra.text.PrintableText;

/**
 * Values as JSON: a record as an object, an instant in ISO 8601 in UTC, a duration in seconds, an
 * absent value or an unknown number (NaN) as null. Characters in a text that are not {@linkplain
 * PrintableText printable} are escaped: the output may go to a terminal, too.
 */
final class Json {

  private static final ObjectMapper MAPPER =
      JsonMapper.builder()
          .addModule(new Times())
          .addModule(new Jdk8Module())
          .addModule(new Durations())
          .addModule(
              new SimpleModule("numbers that are known")
                  .addSerializer(Double.class, new Known())
                  .addSerializer(Double.TYPE, new Known()))
          .disable(SerializationFeature.FAIL_ON_EMPTY_BEANS)
          .build();

  private Json() {}

  /**
   * Reads a value of a type.
   *
   * @throws JsonProcessingException if the text is not such a value
   */
  static Object read(String text, Type type) throws JsonProcessingException {
    return MAPPER.readValue(text, MAPPER.constructType(type));
  }

  static JsonNode tree(Object value) {
    return MAPPER.valueToTree(value);
  }

  /** On several lines. */
  static String pretty(Object value) {
    return write(value, true);
  }

  /** On one line. */
  static String line(Object value) {
    return write(value, false);
  }

  private static String write(Object value, boolean pretty) {
    try {
      return PrintableText.json(
          pretty
              ? MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(value)
              : MAPPER.writeValueAsString(value));
    } catch (JsonProcessingException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** An unknown number is NaN in DFRA's records; JSON has no NaN. */
  private static final class Known extends StdSerializer<Double> {

    private static final long serialVersionUID = 1L;

    Known() {
      super(Double.class);
    }

    @Override
    public void serialize(Double value, JsonGenerator out, SerializerProvider provider)
        throws IOException {
      if (value.isNaN()) {
        out.writeNull();
      } else {
        out.writeNumber(value);
      }
    }
  }

  /** Instants, dates and times in ISO 8601; only instants are read. */
  private static final class Times extends SimpleModule {

    private static final long serialVersionUID = 1L;

    Times() {
      super("times in ISO 8601");
      addSerializer(Temporal.class, new ToStringSerializer(Temporal.class));
      addDeserializer(Instant.class, new FromIso());
    }
  }

  private static final class FromIso extends StdDeserializer<Instant> {

    private static final long serialVersionUID = 1L;

    FromIso() {
      super(Instant.class);
    }

    @Override
    public Instant deserialize(JsonParser in, DeserializationContext context) throws IOException {
      String text = in.getText();
      try {
        return Instant.parse(text);
      } catch (DateTimeParseException e) {
        return (Instant)
            context.handleWeirdStringValue(Instant.class, text, "it is no instant in ISO 8601");
      }
    }
  }

  /** Durations as seconds, like all other durations. */
  private static final class Durations extends SimpleModule {

    private static final long serialVersionUID = 1L;

    Durations() {
      super("durations in seconds");
      addSerializer(Duration.class, new Seconds());
      addDeserializer(Duration.class, new FromSeconds());
    }
  }

  private static final class FromSeconds extends StdDeserializer<Duration> {

    private static final long serialVersionUID = 1L;

    FromSeconds() {
      super(Duration.class);
    }

    @Override
    public Duration deserialize(JsonParser in, DeserializationContext context) throws IOException {
      return Duration.ofNanos(Math.round(in.getDoubleValue() * 1e9));
    }
  }

  private static final class Seconds extends StdSerializer<Duration> {

    private static final long serialVersionUID = 1L;

    Seconds() {
      super(Duration.class);
    }

    @Override
    public void serialize(Duration value, JsonGenerator out, SerializerProvider provider)
        throws IOException {
      out.writeNumber(value.toNanos() / 1e9);
    }
  }
}
