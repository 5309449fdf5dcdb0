package org.dfra.behaviors.perceptual.mines;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.Random;
import org.dfra.behaviors.perceptual.mines.DecodedImage.SummedTable;
import org.dfra.behaviors.perceptual.mines.DetectionWindow.PixelRect;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.junit.jupiter.api.Test;

class DecodedImageTest {

  @Test
  void heatComesToTheHundredthOfAKelvin() {
    BufferedImage image = new BufferedImage(320, 240, BufferedImage.TYPE_USHORT_GRAY);
    image.getRaster().setSample(7, 3, 0, 40_000);
    image.getRaster().setSample(8, 3, 0, 65_535);
    DecodedImage decoded =
        DecodedImage.decode(Ground.image(Band.THERMAL, "image/png", Ground.encoded(image, "png")))
            .orElseThrow();
    SummedTable heat = decoded.channels().get(0);
    assertThat(heat.mean(new PixelRect(7, 3, 8, 4))).isEqualTo(40_000);
    assertThat(heat.mean(new PixelRect(7, 3, 9, 4))).isEqualTo((40_000 + 65_535) / 2.0);
    assertThat(heat.mean(new PixelRect(0, 0, 320, 240)))
        .isCloseTo((40_000 + 65_535) / (320.0 * 240), within(1e-9));
  }

  @Test
  void lightHasRedGreenAndBlue() {
    DecodedImage decoded = DecodedImage.decode(Ground.light(spot -> Ground.OLIVE)).orElseThrow();
    PixelRect box = new PixelRect(100, 100, 200, 200);
    assertThat(decoded.channels().get(0).mean(box)).isCloseTo(0x3F, within(3.0));
    assertThat(decoded.channels().get(1).mean(box)).isCloseTo(0x45, within(3.0));
    assertThat(decoded.channels().get(2).mean(box)).isCloseTo(0x26, within(3.0));
  }

  @Test
  void whatIsNoSuchImageIsNothing() {
    CameraImage whole = Ground.light(spot -> Ground.GRASS);
    byte[] data = whole.data();
    assertThat(DecodedImage.decode(Ground.image(Band.VISIBLE, "image/jpeg", new byte[0])))
        .isEmpty();
    assertThat(DecodedImage.decode(Ground.image(Band.THERMAL, "image/png", data))).isEmpty();
    assertThat(DecodedImage.decode(Ground.image(Band.VISIBLE, "text/html", data))).isEmpty();
    BufferedImage small = new BufferedImage(319, 240, BufferedImage.TYPE_INT_RGB);
    assertThat(
            DecodedImage.decode(
                Ground.image(Band.VISIBLE, "image/jpeg", Ground.encoded(small, "jpeg"))))
        .as("not as large as it says")
        .isEmpty();
    BufferedImage colours = new BufferedImage(320, 240, BufferedImage.TYPE_INT_RGB);
    assertThat(
            DecodedImage.decode(
                Ground.image(Band.THERMAL, "image/png", Ground.encoded(colours, "png"))))
        .as("heat in colours")
        .isEmpty();
  }

  @Test
  void garbageNeverThrows() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    byte[] light = Ground.light(spot -> Ground.GRASS).data();
    byte[] heat = Ground.heat(random, spot -> Ground.WARM).data();
    for (int i = 0; i < 100; i++) {
      boolean isLight = random.nextBoolean();
      byte[] broken = (isLight ? light : heat).clone();
      for (int j = 0; j < 20; j++) {
        broken[random.nextInt(broken.length)] = (byte) random.nextInt();
      }
      byte[] cut = Arrays.copyOf(broken, random.nextInt(broken.length));
      for (byte[] data : new byte[][] {broken, cut}) {
        CameraImage image =
            isLight
                ? Ground.image(Band.VISIBLE, "image/jpeg", data)
                : Ground.image(Band.THERMAL, "image/png", data);
        assertThat(DecodedImage.decode(image))
            .as("-Ddfra.seed=" + seed + ", round " + i)
            .isNotNull();
      }
    }
  }
}
