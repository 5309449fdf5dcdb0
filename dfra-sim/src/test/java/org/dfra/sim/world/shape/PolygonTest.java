package org.dfra.sim.world.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.junit.jupiter.api.Test;

class PolygonTest {

  private static Polygon polygon(double... coordinates) {
    List<Vertex> corners = new ArrayList<>();
    for (int i = 0; i < coordinates.length; i += 2) {
      corners.add(new Vertex(coordinates[i], coordinates[i + 1]));
    }
    return new Polygon(corners);
  }

  @Test
  void goesRoundCounterClockwiseHoweverItIsGiven() {
    Polygon clockwise = polygon(0, 0, 0, 2, 3, 2, 3, 0);
    assertThat(clockwise.area()).isCloseTo(6, within(1e-12));
    assertThat(clockwise.corners())
        .containsExactly(new Vertex(3, 0), new Vertex(3, 2), new Vertex(0, 2), new Vertex(0, 0));
    assertThat(polygon(0, 0, 1, 0, 0, 1, 0, 0).corners()).hasSize(3);
  }

  @Test
  void holdsWhatIsInItAndOnItsEdge() {
    Polygon angle = polygon(0, 0, 4, 0, 4, 1, 1, 1, 1, 4, 0, 4);
    assertThat(angle.contains(0.5, 3)).isTrue();
    assertThat(angle.contains(3, 0.5)).isTrue();
    assertThat(angle.contains(2, 2)).isFalse();
    assertThat(angle.contains(1, 2)).isTrue();
    assertThat(angle.contains(4, 1)).isTrue();
    assertThat(angle.contains(-0.1, 0)).isFalse();
  }

  @Test
  void liesInItsBounds() {
    Polygon angle = polygon(0, 0, 4, 0, 4, 1, 1, 1, 1, 4, 0, 4);
    assertThat(angle.corners())
        .allSatisfy(c -> assertThat(angle.bounds().contains(c.east(), c.north())).isTrue());
    assertThat(angle.bounds().radius()).isLessThan(3);
  }

  @Test
  void refusesWhatIsNone() {
    assertThatThrownBy(() -> polygon(0, 0, 2, 2, 2, 0, 0, 2))
        .hasMessageContaining("crosses itself");
    assertThatThrownBy(() -> polygon(0, 0, 4, 0, 4, 4, 2, 0, 0, 4))
        .as("it touches its own edge")
        .hasMessageContaining("crosses itself");
    assertThatThrownBy(() -> polygon(0, 0, 4, 0, 2, 0)).hasMessageContaining("crosses itself");
    assertThatThrownBy(() -> polygon(0, 0, 4, 0)).hasMessageContaining("three or more");
    assertThatThrownBy(() -> polygon(0, 0, 1e-4, 0, 0, 1e-4)).hasMessageContaining("no area");
    assertThatThrownBy(() -> new Vertex(Double.NaN, 0)).hasMessageContaining("not finite");
    assertThatThrownBy(() -> new Disc(0, 0, -1)).hasMessageContaining("not above 0");
  }
}
