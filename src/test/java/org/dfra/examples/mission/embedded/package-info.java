/**
 * Searches by raster in one virtual machine with real lookup services, end to end. Enter at {@link
 * org.dfra.examples.mission.embedded.EmbeddedMissionIT}.
 */
package org.dfra.examples.mission.embedded;
