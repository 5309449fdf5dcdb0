package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.ObjectStreamConstants;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.rmi.MarshalledObject;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

class RecordedNamesTest {

  private static final String OLD = "org.dfra.core.config.Place";
  private static final String NEW = "org.dfra.core.config.SourceLocation";

  /** Many classes and a marshalled object with others, none of which was renamed. */
  private static Serializable unnamed() throws IOException {
    Map<String, Serializable> map = new TreeMap<>();
    map.put("marshalled", new MarshalledObject<>(List.of("org.dfra.", 1.5)));
    map.put("numbers", new int[] {0x72, 0x7d, -1, 0xACED0005});
    map.put("text", "r" + '\0' + "\u0009org.dfra.");
    return new TreeMap<>(map);
  }

  private static byte[] written(Object object) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(object);
    }
    return bytes.toByteArray();
  }

  private static Object read(byte[] stream) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(stream))) {
      return in.readObject();
    }
  }

  /** The bytes of an object stream with a renamed type, as an older program wrote them. */
  private static byte[] withOldName(byte[] stream) {
    byte[] now = named(NEW);
    byte[] old = named(OLD);
    for (int at = 0; at + now.length <= stream.length; at++) {
      if (Arrays.equals(stream, at, at + now.length, now, 0, now.length)) {
        return joined(
            Arrays.copyOf(stream, at),
            old,
            Arrays.copyOfRange(stream, at + now.length, stream.length));
      }
    }
    throw new AssertionError("no " + NEW + " in the stream");
  }

  private static byte[] named(String type) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes)) {
      out.writeByte(ObjectStreamConstants.TC_CLASSDESC);
      out.writeUTF(type);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  private static byte[] joined(byte[]... parts) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    for (byte[] each : parts) {
      bytes.writeBytes(each);
    }
    return bytes.toByteArray();
  }

  @Test
  void aStreamWithoutOldNamesStaysAsItIs() throws Exception {
    byte[] stream = written(unnamed());
    assertThat(RecordedNames.translate(stream)).isSameAs(stream);
  }

  @Test
  void anOldNameIsReplacedWhereverItStands() throws Exception {
    SourceLocation place = new SourceLocation("robot.xml", 7);
    byte[] now = written(new Serializable[] {unnamed(), place, "after"});
    byte[] old = withOldName(now);
    assertThat(RecordedNames.translate(old)).containsExactly(now);
    assertThat(((Object[]) read(RecordedNames.translate(old)))[1]).isEqualTo(place);
  }

  @Test
  void anOldNameIsReplacedInAStreamInsideAStream() throws Exception {
    byte[] now = written(new SourceLocation("robot.xml", 7));
    byte[] old = withOldName(now);
    byte[] outer = written(new Serializable[] {"before", old, "after", old});
    Object[] translated = (Object[]) read(RecordedNames.translate(outer));
    assertThat(translated).containsExactly("before", now, "after", now);
  }

  @Test
  void noBytesMakeItFail() throws Exception {
    Random random = new Random(4);
    byte[] seed =
        joined(named(OLD), named(NEW), new byte[] {ObjectStreamConstants.TC_PROXYCLASSDESC});
    for (int i = 0; i < 20_000; i++) {
      byte[] bytes = Arrays.copyOf(seed, random.nextInt(seed.length) + 1);
      for (int j = 0; j < 3; j++) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
      }
      assertThat(RecordedNames.translate(bytes)).isNotNull();
    }
    byte[] cut = Arrays.copyOf(withOldName(written(new SourceLocation("robot.xml", 7))), 40);
    assertThat(RecordedNames.translate(cut)).isSameAs(cut);
    byte[] text = "no object stream".getBytes(StandardCharsets.UTF_8);
    assertThat(RecordedNames.translate(text)).isSameAs(text);
  }
}
