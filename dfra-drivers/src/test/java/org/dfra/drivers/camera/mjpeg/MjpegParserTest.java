package org.dfra.drivers.camera.mjpeg;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Ended;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Malformed;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Part;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Response;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A failing test with random bytes shows its seed; {@code -Ddfra.seed=n} repeats it. */
class MjpegParserTest {

  private static final int FRAMES = Boolean.getBoolean("dfra.full") ? 20_000 : 600;
  private static final int LARGEST = 20_000;
  private static final String HEAD =
      "HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=frame\r\n\r\n";

  private static final List<byte[]> IMAGES = images();

  private final List<MjpegMessage> received = new ArrayList<>();
  private final MjpegParser parser = new MjpegParser(LARGEST, received::add);
  private final byte[] image = Images.jpeg(16, 8, new Random(1));

  static long[] seeds() {
    return new long[] {1, 2, Long.getLong("dfra.seed", new Random().nextLong())};
  }

  @Test
  void readsPartsWithALength() {
    feed(HEAD, "--frame\r\nContent-Type: image/jpeg\r\nContent-Length: " + image.length);
    feed("\r\nX-Timestamp: 12.5\r\n\r\n", image, "\r\n--frame\r\n");
    assertThat(received).hasSize(2);
    assertThat(((Response) received.get(0)).head().boundary()).isEqualTo("frame");
    Part part = (Part) received.get(1);
    assertThat(part.data()).isEqualTo(image);
    assertThat(part.head().header("x-timestamp")).isEqualTo("12.5");
    assertThat(part.head().mediaType()).isEqualTo("image/jpeg");
    assertThat(part.shape()).isEqualTo(new ImageFormat("image/jpeg", 16, 8, 8, false));
    assertThat(parser.counts().droppedBytes()).isZero();
  }

  @Test
  void reportsAPartWithALengthWithItsLastByte() {
    feed(HEAD, "--frame\r\nContent-Length: " + image.length + "\r\n\r\n");
    parser.feed(image, 0, image.length - 1);
    assertThat(received).hasSize(1);
    parser.feed(image, image.length - 1, 1);
    assertThat(received).hasSize(2);
  }

  @Test
  void readsPartsWithoutALengthWhenTheNextOneBegins() {
    feed(HEAD, "--frame\r\nContent-Type: image/jpeg\r\n\r\n", image);
    assertThat(received).hasSize(1);
    feed("\r\n--frame\r\n\r\n", image, "\r\n--frame--\r\n");
    assertThat(received.subList(1, 3)).allMatch(Part.class::isInstance);
    assertThat(((Part) received.get(2)).data()).as("of no head at all").isEqualTo(image);
    assertThat(received.get(3)).isEqualTo(new Ended("the camera has ended its stream"));
    assertThat(parser.counts().droppedBytes()).isZero();
  }

  @Test
  void takesBoundariesAsCamerasWriteThem() {
    for (String[] way :
        new String[][] {
          {"boundary=frame", "--frame"},
          {"boundary=\"frame\"", "--frame"},
          {"boundary=--frame", "--frame"},
          {"boundary=--frame", "----frame"},
          {"Boundary = frame ; charset=x", "--frame"},
        }) {
      received.clear();
      MjpegParser other = new MjpegParser(LARGEST, received::add);
      String head = "HTTP/1.1 200\nContent-Type: multipart/x-mixed-replace;" + way[0] + "\n\n";
      byte[] stream =
          bytes(
              head, way[1] + "  \n\n", image, "\n" + way[1] + "\n\n", image, "\n" + way[1] + "\n");
      other.feed(stream, 0, stream.length);
      assertThat(received).as(String.join(" ", way)).hasSize(3);
      assertThat(((Part) received.get(2)).data()).isEqualTo(image);
      assertThat(other.counts().droppedBytes()).isZero();
    }
  }

  @Test
  void doesNotTakeAnotherWordForTheBoundary() {
    feed(HEAD, "--framework\r\n\r\n", "--frame\r\n\r\n", image, "x--frame", image);
    feed("\r\n--frame\r\n");
    assertThat(received.get(1)).as("the boundary within the image").isInstanceOf(Part.class);
    assertThat(((Part) received.get(1)).data().length).isEqualTo(2 * image.length + 8);
  }

  @Test
  void findsTheNextImageWhereALengthIsWrong() {
    for (int off : new int[] {-5, 5, 2000, 19_000 - image.length}) {
      received.clear();
      MjpegParser other = new MjpegParser(LARGEST, received::add);
      ByteArrayOutputStream stream = new ByteArrayOutputStream();
      stream.writeBytes(bytes(HEAD, part(image.length + off), image));
      for (int i = 0; i < 40; i++) {
        stream.writeBytes(bytes("\r\n", part(image.length), image));
      }
      other.feed(stream.toByteArray(), 0, stream.size());
      assertThat(received.stream().filter(Part.class::isInstance)).as("%s", off).hasSize(40);
      assertThat(received.get(1)).isEqualTo(new Malformed("a part is not a complete image"));
    }
  }

  @Test
  void refusesPartsThatAreTooLargeAndHoldsNoMoreThanAllowed() {
    feed(HEAD, part(LARGEST + 1), new byte[LARGEST + 1], "\r\n", part(image.length), image);
    feed("\r\n--frame\r\n\r\n", new byte[10 * LARGEST], "\r\n", part(image.length), image);
    feed("\r\n--frame\r\nContent-Length: -3\r\n\r\n", "\r\n", part(image.length), image);
    feed("\r\n--frame\r\nX: " + "y".repeat(100_000), "\r\n", part(image.length), image);
    assertThat(received.stream().filter(Part.class::isInstance)).hasSize(4);
    assertThat(received.stream().filter(Malformed.class::isInstance))
        .containsExactly(
            new Malformed("a part of 20001 bytes is larger than 20000"),
            new Malformed("a part without a Content-Length is larger than 20000 bytes"),
            new Malformed("a part's Content-Length is not a number: -3"),
            new Malformed("a part's head has no end"));
    assertThat(parser.counts().malformed()).isEqualTo(4);
    assertThat(parser.counts().frames()).isEqualTo(8);
    assertThat(parser.capacity()).isLessThanOrEqualTo(LARGEST + MjpegParser.LONGEST_HEAD);
  }

  @Test
  void reportsNothingMoreAfterWhatIsNoStream() {
    for (String[] wrong :
        new String[][] {
          {"SSH-2.0-OpenSSH_9.2\r\n", "the answer is not HTTP"},
          {"$GPGGA,1,2,3\r\n", "the answer is not HTTP"},
          {"HTTP/2 200 OK\r\n\r\n", "its status line is none of HTTP"},
          {"HTTP/1.0 200 OK\r\nX: " + "y".repeat(9000), "its head has no end"},
        }) {
      received.clear();
      MjpegParser other = new MjpegParser(LARGEST, received::add);
      byte[] stream = bytes(wrong[0], HEAD, part(image.length), image);
      other.feed(stream, 0, stream.length);
      assertThat(received).containsExactly(new Ended(wrong[1]));
      other.finish();
      assertThat(other.pendingBytes()).isZero();
      byte[] right = bytes(HEAD, part(image.length), image);
      other.feed(right, 0, right.length);
      assertThat(received).as("another stream").hasSize(3);
    }
  }

  @ParameterizedTest(name = "-Ddfra.seed={0}")
  @MethodSource("seeds")
  void findsEveryImageOfAnIntactStreamHoweverItIsCut(long seed) {
    Random random = new Random(seed);
    List<byte[]> images = new ArrayList<>();
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    stream.writeBytes(bytes(HEAD));
    for (int i = 0; i < FRAMES; i++) {
      byte[] next = image(random);
      images.add(next);
      boolean isCounted = random.nextBoolean();
      stream.writeBytes(bytes(isCounted ? part(next.length) : "--frame\r\n\r\n", next, "\r\n"));
    }
    stream.writeBytes(bytes("--frame\r\n"));
    feedInRandomCuts(stream.toByteArray(), random);
    List<byte[]> reported =
        received.stream().filter(Part.class::isInstance).map(part -> ((Part) part).data()).toList();
    assertThat(reported).hasSameSizeAs(images);
    for (int i = 0; i < reported.size(); i++) {
      assertThat(reported.get(i)).as("image %s", i).isEqualTo(images.get(i));
    }
    assertThat(parser.counts().droppedBytes()).isZero();
  }

  @ParameterizedTest(name = "-Ddfra.seed={0}")
  @MethodSource("seeds")
  void isInStepAgainByTheNextBoundaryAfterDamage(long seed) {
    Random random = new Random(seed);
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    stream.writeBytes(bytes(HEAD));
    int intact = 0;
    boolean wasDamaged = false;
    for (int i = 0; i < FRAMES; i++) {
      byte[] next = image(random);
      byte[] whole = bytes(part(next.length), next, "\r\n");
      boolean isDamaged = random.nextInt(3) == 0;
      stream.writeBytes(isDamaged ? damaged(whole, random) : whole);
      // A part whose end is gone takes the next with it only where it has no boundary of its own.
      intact += isDamaged || wasDamaged ? 0 : 1;
      wasDamaged = isDamaged;
    }
    feedInRandomCuts(stream.toByteArray(), random);
    long reported = received.stream().filter(Part.class::isInstance).count();
    assertThat(reported).isGreaterThanOrEqualTo(intact);
    assertThat(reported).isLessThanOrEqualTo(FRAMES);
  }

  @ParameterizedTest(name = "-Ddfra.seed={0}")
  @MethodSource("seeds")
  void neverThrowsOnNoise(long seed) {
    Random random = new Random(seed);
    String[] words = {
      "HTTP/1.0 200 OK\r\n",
      "--frame",
      "\r\n",
      "Content-Length: ",
      "99",
      "\r\n\r\n",
      "--",
      ":",
      "\n"
    };
    for (int stream = 0; stream < 40; stream++) {
      ByteArrayOutputStream noise = new ByteArrayOutputStream();
      if (random.nextBoolean()) {
        noise.writeBytes(bytes(HEAD));
      }
      while (noise.size() < 50_000) {
        byte[] random16 = new byte[random.nextInt(16)];
        random.nextBytes(random16);
        noise.writeBytes(
            random.nextBoolean() ? random16 : bytes(words[random.nextInt(words.length)]));
      }
      feedInRandomCuts(noise.toByteArray(), random);
    }
  }

  private void feedInRandomCuts(byte[] stream, Random random) {
    long before = parser.imageBytes() + parser.structureBytes() + parser.counts().droppedBytes();
    for (int at = 0; at < stream.length; ) {
      int most = random.nextBoolean() ? 30 : 9000;
      int count = Math.min(1 + random.nextInt(most), stream.length - at);
      parser.feed(stream, at, count);
      at += count;
      assertThat(
              parser.imageBytes()
                  + parser.structureBytes()
                  + parser.counts().droppedBytes()
                  + parser.pendingBytes()
                  - before)
          .isEqualTo(at);
      assertThat(parser.capacity()).isLessThanOrEqualTo(LARGEST + MjpegParser.LONGEST_HEAD);
    }
    parser.finish();
    assertThat(parser.pendingBytes()).isZero();
  }

  /** One of a few hundred, from 1 x 1 to 24 x 24: to encode each image took most of the time. */
  private static byte[] image(Random random) {
    return IMAGES.get(random.nextInt(IMAGES.size()));
  }

  private static List<byte[]> images() {
    Random random = new Random(3);
    List<byte[]> images = new ArrayList<>();
    for (int i = 0; i < 300; i++) {
      int width = 1 + random.nextInt(24);
      int height = 1 + random.nextInt(24);
      images.add(
          random.nextBoolean()
              ? Images.jpeg(width, height, random)
              : Images.heat(width, height, random));
    }
    return images;
  }

  private static byte[] damaged(byte[] whole, Random random) {
    int at = random.nextInt(whole.length);
    int lost = 1 + random.nextInt(Math.min(200, whole.length));
    int end = Math.min(whole.length, at + lost);
    byte[] noise = new byte[random.nextInt(3) == 0 ? random.nextInt(300) : 0];
    random.nextBytes(noise);
    return bytes(Arrays.copyOf(whole, at), noise, Arrays.copyOfRange(whole, end, whole.length));
  }

  private static String part(int length) {
    return "--frame\r\nContent-Type: image/x\r\nContent-Length: " + length + "\r\n\r\n";
  }

  private void feed(Object... pieces) {
    byte[] all = bytes(pieces);
    parser.feed(all, 0, all.length);
  }

  private static byte[] bytes(Object... pieces) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (Object piece : pieces) {
      all.writeBytes(piece instanceof byte[] raw ? raw : ((String) piece).getBytes(ISO_8859_1));
    }
    return all.toByteArray();
  }
}
