package org.dfra.behaviors.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import org.dfra.behavior.GoalRefusedException;
import org.dfra.geometry.GeoPosition;
import org.junit.jupiter.api.Test;

class RegionTest {

  @Test
  void knowsItsCentreAndArea() {
    Region region = Field.rectangle(30, 20);
    assertThat(region.area()).isCloseTo(600, within(1e-3));
    GeoPosition middle = Field.positions(15, 10).get(0);
    assertThat(region.centre().groundDistance(middle)).isLessThan(1e-3);
    assertThat(region.centre().height()).isZero();
  }

  @Test
  void leavesOutCornersThatAreGivenAgain() {
    List<GeoPosition> corners = Field.positions(0, 0, 0, 0, 9, 0, 9, 9, 9, 9, 0, 0);
    assertThat(Region.of(corners).corners()).hasSize(3);
  }

  @Test
  void liesAcrossTheAntimeridianAndNearThePole() {
    Region region =
        RegionParser.parse("10,179.9999 10,-179.9999 10.0002,-179.9999 10.0002,179.9999");
    // 0.0002° each way; a degree is 109.64 km eastward and 110.61 km northward there
    assertThat(region.area()).isCloseTo(21.93 * 22.12, within(1.0));
    assertThat(Math.abs(region.centre().longitude())).isCloseTo(180, within(1e-9));
    assertThat(RegionParser.parse("89.9999,0 89.9999,120 89.9999,-120").centre().latitude())
        .isCloseTo(90, within(1e-9));
  }

  @Test
  void refusesFewerThanThreeDifferentCorners() {
    refuses(List.of(), "a region of 0 different corners encloses nothing; give three or more");
    refuses(
        Field.positions(0, 0, 5, 5, 0, 0, 5, 5),
        "a region of 2 different corners encloses nothing; give three or more");
  }

  @Test
  void refusesTooManyCorners() {
    double[] circle = new double[1002];
    for (int i = 0; i < circle.length; i += 2) {
      circle[i] = 100 * Math.cos(2 * Math.PI * i / circle.length);
      circle[i + 1] = 100 * Math.sin(2 * Math.PI * i / circle.length);
    }
    refuses(
        Field.positions(circle),
        "a region of 501 corners has too many; simplify its outline to 500 or fewer");
  }

  @Test
  void refusesWhatEnclosesNoArea() {
    refuses(
        Field.positions(0, 0, 20, 0, 10, 1e-4),
        "the region at 48.0000000°,11.0000000° encloses almost no area; give corners that do"
            + " not lie on one line");
    assertThatThrownBy(() -> Region.of(Field.positions(0, 0, 20, 20, 10, 10)))
        .isInstanceOf(GoalRefusedException.class);
  }

  @Test
  void saysWhereAnOutlineCrossesItself() {
    List<GeoPosition> bow =
        List.of(
            new GeoPosition(48, 11, 0),
            new GeoPosition(48.0002, 11.0002, 0),
            new GeoPosition(48.0002, 11, 0),
            new GeoPosition(48, 11.0002, 0));
    refuses(
        bow,
        "the outline of the region crosses itself at 48.0001000°,11.0001000°, where the edge from"
            + " corner 1 to corner 2 meets that from corner 3 to corner 4; give the corners in"
            + " their order around it");
  }

  @Test
  void refusesAnOutlineThatTouchesItselfOrGoesBack() {
    assertThatThrownBy(() -> Field.region(0, 0, 10, 0, 5, 5, 10, 10, 0, 10, 5, 5))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessageContaining("from corner 2 to corner 3 meets that from corner 5 to corner 6");
    assertThatThrownBy(() -> Field.region(0, 0, 10, 0, 10, 10, 20, 20, 10, 10, 0, 10))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessageContaining("crosses itself");
  }

  @Test
  void refusesCornersThatNoRobotDrivesBetween() {
    refuses(
        List.of(
            new GeoPosition(48, 11, 0),
            new GeoPosition(48.0001, 11, 0),
            new GeoPosition(11.0001, 48.0001, 0)),
        "corners 1 and 3 of the region, 48.0000000°,11.0000000° and 11.0001000°,48.0001000°, are"
            + " 5199.2 km apart, more than 10 km; correct them, and check that latitude and"
            + " longitude are not swapped");
  }

  @Test
  void doesNotMindTheDirectionOfItsCorners() {
    List<GeoPosition> corners = Field.positions(0, 0, 20, 3, 12, 15);
    Region one = Region.of(corners);
    Collections.reverse(corners);
    Region other = Region.of(corners);
    assertThat(other.area()).isCloseTo(one.area(), within(1e-9));
    assertThat(RasterPlan.of(other, 2, 1.5, 0).length())
        .isCloseTo(RasterPlan.of(one, 2, 1.5, 0).length(), within(1e-3));
  }

  private static void refuses(List<GeoPosition> corners, String message) {
    assertThatThrownBy(() -> Region.of(corners))
        .isInstanceOf(GoalRefusedException.class)
        .hasMessage(message);
  }
}
