package org.dfra.behaviors.perceptual.mines;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import org.dfra.behaviors.perceptual.mines.ImageMineDetector.ImageDetections;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.flow.sensor.CameraImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** On painted ground, where mines are flat, as the detector is configured. */
class ImageMineDetectorTest {

  private static final ImageMineDetectorSettings USUAL = ImageMineDetectorSettings.DEFAULT;
  private static final ImageMineDetectorSettings FLAT =
      new ImageMineDetectorSettings(
          USUAL.radius(),
          0,
          USUAL.colour(),
          USUAL.minDistance(),
          USUAL.maxDistance(),
          USUAL.minThermalContrast(),
          USUAL.minVisibleContrast(),
          USUAL.colourTolerance());
  private static final double CLOSE = 0.08; // metres: a place of the lattice and a half
  private static final GroundPoint MINE = new GroundPoint(2, 0.4);

  private static List<GroundPoint> found(CameraImage image) {
    return new ImageMineDetector(FLAT).detect(image, Ground.MOUNT).orElseThrow().points();
  }

  private static boolean isOnMine(GroundPoint spot) {
    return spot.distance(MINE) < USUAL.radius();
  }

  @ParameterizedTest
  @CsvSource({"300, true", "-200, true", "60, false", "0, false"})
  void heatThatDiffersIsFoundWarmOrCold(int hundredths, boolean isFound) {
    List<GroundPoint> found =
        found(Ground.heat(new Random(1), spot -> Ground.WARM + (isOnMine(spot) ? hundredths : 0)));
    assertThat(found).hasSize(isFound ? 1 : 0);
    assertThat(found).allMatch(spot -> spot.distance(MINE) < CLOSE);
  }

  @Test
  void aStripOfColdIsNoMine() {
    for (int degrees = 0; degrees < 180; degrees += 15) {
      double angle = Math.toRadians(degrees);
      List<GroundPoint> found =
          found(
              Ground.heat(
                  new Random(1),
                  spot ->
                      Ground.WARM
                          - (Math.abs(
                                      Math.sin(angle) * (spot.x() - MINE.x())
                                          - Math.cos(angle) * (spot.y() - MINE.y()))
                                  < 0.12
                              ? 500
                              : 0)));
      assertThat(found).as("strip at %d°", degrees).isEmpty();
    }
  }

  @Test
  void whatIsDarkAndOliveIsFound() {
    List<GroundPoint> found =
        found(Ground.light(spot -> isOnMine(spot) ? Ground.OLIVE : Ground.GRASS));
    assertThat(found).hasSize(1);
    assertThat(found.get(0).distance(MINE)).isLessThan(CLOSE);
  }

  @Test
  void dimLightChangesNothing() {
    List<GroundPoint> found = found(Ground.light(spot -> isOnMine(spot) ? 0x202313 : 0x293619));
    assertThat(found).hasSize(1);
  }

  @Test
  void whatIsDarkAndOfAnotherColourIsNone() {
    assertThat(found(Ground.light(spot -> isOnMine(spot) ? 0x2B381A : Ground.GRASS)))
        .as("a shadow on grass")
        .isEmpty();
    assertThat(found(Ground.light(spot -> isOnMine(spot) ? 0x404040 : Ground.GRASS)))
        .as("grey")
        .isEmpty();
  }

  @Test
  void whatIsBrightIsNone() {
    assertThat(found(Ground.light(spot -> isOnMine(spot) ? 0xFF8A4C : Ground.GRASS))).isEmpty();
  }

  @Test
  void twoMinesAreTwo() {
    GroundPoint other = new GroundPoint(2.4, -0.5);
    List<GroundPoint> found =
        found(
            Ground.heat(
                new Random(1),
                spot ->
                    Ground.WARM
                        + (isOnMine(spot) || spot.distance(other) < USUAL.radius() ? 300 : 0)));
    assertThat(found).hasSize(2);
    assertThat(found).anyMatch(spot -> spot.distance(MINE) < CLOSE);
    assertThat(found).anyMatch(spot -> spot.distance(other) < CLOSE);
  }

  @Test
  void whatIsOutsideThePictureIsNotSeen() {
    ImageDetections glance =
        new ImageMineDetector(FLAT)
            .detect(Ground.light(spot -> Ground.GRASS), Ground.MOUNT)
            .orElseThrow();
    assertThat(glance.covers(MINE)).isTrue();
    assertThat(glance.covers(new GroundPoint(1.2, 1.2))).as("beside the picture").isFalse();
    assertThat(glance.covers(new GroundPoint(3.7, 0))).as("too far").isFalse();
    assertThat(glance.covers(new GroundPoint(-1, 0))).as("behind").isFalse();
  }
}
