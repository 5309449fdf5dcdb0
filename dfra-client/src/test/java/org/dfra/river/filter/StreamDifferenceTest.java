package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.ObjectStreamConstants;
import java.io.Serializable;
import java.io.StreamCorruptedException;
import java.util.Arrays;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Streams that an object stream reads otherwise than they seem to be. Each hides an object where a
 * reader that believes the descriptions sees none.
 */
class StreamDifferenceTest implements ObjectStreamConstants {

  private static final String ANY = "Ljava/lang/Object;";

  /** How many hidden objects were built. */
  private static int built;

  private static final class Hidden implements Serializable {
    private static final long serialVersionUID = 1L;

    private void readObject(ObjectInputStream in) {
      built++;
    }
  }

  private record Pair(int first) implements Serializable {}

  /** Writes what no object stream would. */
  private static final class Forged {

    final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    final DataOutputStream out = new DataOutputStream(bytes);

    Forged() throws IOException {
      out.writeShort(STREAM_MAGIC);
      out.writeShort(STREAM_VERSION);
    }

    /** Begins the description of a class, as far as the number of its fields. */
    Forged describe(int tag, String name, long version, int flags, int fields) throws IOException {
      out.writeByte(tag);
      out.writeByte(TC_CLASSDESC);
      out.writeUTF(name);
      out.writeLong(version);
      out.writeByte(flags);
      out.writeShort(fields);
      return this;
    }

    Forged field(char code, String name) throws IOException {
      out.writeByte(code);
      out.writeUTF(name);
      return this;
    }

    Forged string(String text) throws IOException {
      out.writeByte(TC_STRING);
      out.writeUTF(text);
      return this;
    }

    /** Ends a description: no annotation, no superclass. */
    Forged described() throws IOException {
      out.writeByte(TC_ENDBLOCKDATA);
      out.writeByte(TC_NULL);
      return this;
    }
  }

  private static byte[] hidden() throws IOException {
    byte[] stream = Payload.bytes(new Hidden());
    return Arrays.copyOfRange(stream, 4, stream.length);
  }

  @BeforeEach
  void reset() {
    built = 0;
  }

  @Test
  void aReferenceWhoseTypeIsThatOfAValue() throws Exception {
    Forged forged = new Forged();
    forged.describe(TC_OBJECT, "elsewhere.Value", 1, SC_SERIALIZABLE, 2);
    forged.field('L', "a").string("J").field('L', "b").string(ANY).described();
    byte[] hidden = hidden(); // after the eight bytes of the value
    forged.out.writeByte(TC_STRING);
    forged.out.writeShort(5 + hidden.length);
    forged.out.write(new byte[5]);
    forged.out.write(hidden);
    forged.out.writeByte(TC_NULL);
    assertOnlyAnObjectStreamBuildsIt(forged, "has another type");
  }

  @Test
  void aReferenceBackToAStringThatIsTheTypeOfAValue() throws Exception {
    Forged forged = new Forged();
    forged.string("J");
    forged.describe(TC_OBJECT, "elsewhere.Value", 1, SC_SERIALIZABLE, 1).field('L', "a");
    forged.out.writeByte(TC_REFERENCE);
    forged.out.writeInt(baseWireHandle);
    forged.described().out.writeByte(TC_NULL);
    assertThatThrownBy(() -> readAll(scanned(forged)))
        .isInstanceOf(StreamCorruptedException.class)
        .hasMessageContaining("has another type");
  }

  @Test
  void aNegativeNumberOfFields() throws Exception {
    Forged forged = new Forged();
    forged.describe(TC_OBJECT, "elsewhere.Wide", 1, SC_SERIALIZABLE | SC_WRITE_METHOD, -1);
    forged.described().out.write(hidden());
    forged.out.writeByte(TC_ENDBLOCKDATA);
    assertOnlyAnObjectStreamBuildsIt(forged, "-1 fields");
  }

  @Test
  void anArrayOfAClassThatIsNone() throws Exception {
    for (String name : new String[] {"elsewhere.Array", "[Bytes", "[V"}) {
      Forged forged = new Forged();
      forged.describe(TC_ARRAY, name, 1, SC_SERIALIZABLE, 0).described();
      byte[] hidden = hidden();
      forged.out.writeInt(hidden.length);
      forged.out.write(hidden);
      assertOnlyAnObjectStreamBuildsIt(forged, "an array of class " + name);
    }
  }

  @Test
  void aRecordThatWritesMoreThanItsFields() throws Exception {
    for (int flag : new int[] {SC_SERIALIZABLE | SC_WRITE_METHOD, SC_EXTERNALIZABLE}) {
      Forged forged = new Forged();
      forged.describe(TC_OBJECT, Pair.class.getName(), 0, flag | SC_BLOCK_DATA, 0).described();
      forged.out.write(new byte[] {TC_BLOCKDATA, 1, 0, TC_ENDBLOCKDATA});
      assertThatThrownBy(() -> readAll(scanned(forged)))
          .isInstanceOf(StreamCorruptedException.class)
          .hasMessageContaining("is a record");
    }
    Forged extending = new Forged();
    extending.describe(TC_OBJECT, Pair.class.getName(), 0, SC_SERIALIZABLE, 0);
    extending.out.writeByte(TC_ENDBLOCKDATA);
    extending.out.writeByte(TC_PROXYCLASSDESC); // any other class will do
    extending.out.writeInt(0);
    extending.described();
    assertThatThrownBy(() -> readAll(scanned(extending)))
        .isInstanceOf(StreamCorruptedException.class)
        .hasMessageContaining("is a record");
    assertThat(readOne(scan(Payload.bytes(new Pair(7))))).isEqualTo(new Pair(7));
  }

  @Test
  void onlySoManyClassesAreLookedForInVain() throws Exception {
    Forged forged = new Forged();
    for (int i = 0; i <= LocalRecordClasses.UNKNOWN; i++) {
      String name = "elsewhere.Unknown" + i;
      forged.describe(TC_OBJECT, name, 1, SC_SERIALIZABLE | SC_WRITE_METHOD, 0).described();
      forged.out.writeByte(TC_ENDBLOCKDATA);
    }
    assertThatThrownBy(() -> scanned(forged).readAllBytes())
        .hasCauseInstanceOf(RefusedDataException.class)
        .hasMessageContaining("more than 64 classes that are not known here");
  }

  @Test
  void whatReadsItselfReadsNoOthers() throws Exception {
    Forged forged = new Forged();
    forged.describe(TC_OBJECT, "java.util.Date", 7523967970034938905L, SC_SERIALIZABLE, 0);
    forged.described().out.writeByte(TC_NULL);
    assertThatThrownBy(() -> readAll(scanned(forged)))
        .isInstanceOf(StreamCorruptedException.class)
        .hasMessageContaining("java.util.Date without data of its own");
    assertThat(readOne(scan(Payload.bytes(new java.util.Date(5)))))
        .isEqualTo(new java.util.Date(5));
  }

  /** The stream is such as an object stream reads, and the scanner does not let it pass. */
  private static void assertOnlyAnObjectStreamBuildsIt(Forged forged, String why)
      throws IOException {
    built = 0;
    assertThatThrownBy(() -> readOne(new ByteArrayInputStream(forged.bytes.toByteArray())))
        .isInstanceOfAny(ClassNotFoundException.class, IOException.class);
    assertThat(built).as("hidden objects that an object stream builds").isEqualTo(1);
    built = 0;
    assertThatThrownBy(() -> readAll(scanned(forged)))
        .isInstanceOf(StreamCorruptedException.class)
        .hasMessageContaining(why);
    assertThat(built).isZero();
  }

  private static InputStream scanned(Forged forged) {
    return scan(forged.bytes.toByteArray());
  }

  private static InputStream scan(byte[] bytes) {
    return ScannedStream.of(new ByteArrayInputStream(bytes), SerialLimits.CALL);
  }

  private static Object readOne(InputStream bytes) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in = new ObjectInputStream(bytes)) {
      return in.readObject();
    }
  }

  private static void readAll(InputStream bytes) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in = new ObjectInputStream(bytes)) {
      Object unused = in.readObject();
      unused = in.readObject();
    }
  }
}
